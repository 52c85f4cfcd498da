#if FLT_MANT_DIG != 24 || FLT_EVAL_METHOD != 0
#error "float must be the 32-bit format of IEEE 754, and be computed in it: on x86, compile with -msse2 -mfpmath=sse"
#endif
