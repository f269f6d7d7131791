package org.robotui.rtps.internal.endpoint;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Sample;
import org.robotui.rtps.SampleIdentity;

/**
 * A sample with its number, as writers keep it and readers receive it.
 *
 * @param payload from the encapsulation header on; where an instance ended, its key, or nothing. It is never changed
 * @param sourceNanos when it was written, since 1970, or {@link Sample#NO_TIME}
 * @param related the sample that it answers
 * @param instance which instance of a built-in topic it is about, as far as that is said beside the payload
 */
public record Change(long sequence, Sample.Kind kind, ByteBuffer payload, long sourceNanos,
    Optional<SampleIdentity> related, Optional<Guid> instance) {

  /** The bytes of the payload. */
  int size() {
    return payload.remaining();
  }
}
