package org.robotui.rtps;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.OptionalLong;

/** Writes samples of a topic. */
public interface Writer extends Endpoint {

  /**
   * Writes a sample. Never blocks. It is sent on this thread if the network takes it at once; of a sample of more than
   * 128 KiB the rest goes in turns within the next milliseconds, so that the buffers of readers take it, and what is
   * written meanwhile goes behind it. What reliable readers did not get is sent again later, as long as the history
   * holds it. A history that keeps the last drops its oldest sample for a new one, acknowledged or not.
   *
   * @param payload the bytes from the encapsulation header on, from position to limit; they are copied, and the
   * position stays
   * @return the number of the sample, from 1 on; empty if the history keeps all and is full of samples that reliable
   * readers did not acknowledge, or if the writer is closed: then nothing was written
   * @throws IllegalArgumentException if it is longer than a writer may send
   */
  OptionalLong write(ByteBuffer payload);

  /**
   * Writes a sample that answers another one, as {@link #write(ByteBuffer)} does.
   *
   * @param payload the bytes
   * @param related the sample that it answers: readers find it as {@link Sample#related}
   * @return the number of the sample, or empty if nothing was written
   * @throws IllegalArgumentException if it is longer than a writer may send
   */
  OptionalLong write(ByteBuffer payload, SampleIdentity related);

  /**
   * Writes a sample as {@link #write(ByteBuffer)} does, without copying it: for large ones.
   *
   * @param payload the bytes, from position to limit; whoever has them must not change them again, as the history keeps
   * them
   * @return the number of the sample, or empty if nothing was written
   * @throws IllegalArgumentException if it is longer than a writer may send
   */
  default OptionalLong writeKept(ByteBuffer payload) {
    return write(payload);
  }

  /**
   * Says to all reliable readers that this writer is alive, as {@link Liveliness#MANUAL_BY_TOPIC} demands within the
   * lease of its quality of service. Writing a sample says it as well; for {@link Liveliness#AUTOMATIC} the participant
   * does, by itself. Does not block.
   */
  void assertLiveliness();

  /**
   * Blocks until all reliable readers have acknowledged what was written before this call.
   *
   * @param timeout no longer than this
   * @return whether they have
   * @throws InterruptedException if interrupted
   */
  boolean awaitAcknowledged(Duration timeout) throws InterruptedException;

  /**
   * What was counted.
   *
   * @return the figures so far
   */
  WriterStatistics statistics();
}
