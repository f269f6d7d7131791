package org.robotui.rtps;

/**
 * How much memory peers may take. What is above is not taken, and counted.
 *
 * @param participants how many participants are known at most
 * @param endpoints how many endpoints one participant may have
 * @param sampleBytes the longest sample that is accepted
 * @param partialBytes how much memory samples of one writer may hold of which fragments are missing
 * @param cacheBytes how much memory the samples of one of our writers or readers may hold
 */
public record ParticipantLimits(int participants, int endpoints, int sampleBytes, long partialBytes, long cacheBytes) {

  /** Checks the bounds. */
  public ParticipantLimits {
    if (participants < 1 || endpoints < 1 || sampleBytes < 1 || partialBytes < sampleBytes || cacheBytes < 1) {
      throw new IllegalArgumentException("limits of %d participants, %d endpoints, %d, %d and %d bytes"
          .formatted(participants, endpoints, sampleBytes, partialBytes, cacheBytes));
    }
  }

  /**
   * 1000 participants, 2000 endpoints each, samples of 64 MiB, 64 MiB of partial ones of a writer, 64 MiB of a cache.
   *
   * @return the default
   */
  public static ParticipantLimits standard() {
    return new ParticipantLimits(1000, 2000, 64 << 20, 64L << 20, 64L << 20);
  }
}
