package org.robotui.core.internal.fence;

/**
 * How much memory all components may take together, and how the user gives them more: the launcher sets the bound by
 * ROBOTUI_MEMORY (docs/adr/0101).
 */
public final class HeapBound {
  private static final long MEGABYTE = 1 << 20;
  private static final long MEGABYTES_PER_GIGABYTE = 1024;

  private HeapBound() {}

  /** The bound of this process, in bytes. */
  public static long bytes() {
    return Runtime.getRuntime().maxMemory();
  }

  /**
   * As the user writes and reads it: whole megabytes, rounded up, so that what may take 64 MB is not said to take 63.
   */
  public static long megabytes(long bytes) {
    return Math.ceilDiv(bytes, MEGABYTE);
  }

  /** How to start with twice as much as this bound: what fits {@code start it with ...}. */
  public static String remedy(long bound) {
    long wanted = 2 * megabytes(bound);
    return "ROBOTUI_MEMORY="
        + (wanted < MEGABYTES_PER_GIGABYTE ? wanted + "m" : Math.ceilDiv(wanted, MEGABYTES_PER_GIGABYTE) + "g");
  }
}
