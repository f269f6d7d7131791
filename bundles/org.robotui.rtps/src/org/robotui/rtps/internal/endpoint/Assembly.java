package org.robotui.rtps.internal.endpoint;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Optional;

/**
 * A sample of which fragments came. Its memory grows with what came, not with what a header claims. Its reader's lock
 * guards it.
 */
final class Assembly {

  /** A fragment may lie so far ahead of what came. */
  private static final int AHEAD = 1 << 20;

  /** Memory for so many bytes is there for a first fragment, and for so many times what came later on. */
  private static final int FIRST = 64 << 10;
  private static final int TIMES = 32;

  private final int sampleSize;
  private final int fragmentSize;
  private final int count;
  private final BitSet seen;
  private byte[] bytes = new byte[0];
  private int received;
  private Change about;
  private long progress;

  private Assembly(int sampleSize, int fragmentSize, Change about, long now) {
    this.sampleSize = sampleSize;
    this.fragmentSize = fragmentSize;
    this.count = (sampleSize + fragmentSize - 1) / fragmentSize;
    this.seen = new BitSet();
    this.about = about;
    this.progress = now;
  }

  /** Begins with the sizes that fragments name; empty if such a sample is not taken. */
  static Optional<Assembly> begin(Fragments fragments, int mostBytes, long now) {
    boolean sane = fragments.sampleSize() >= 1 && fragments.sampleSize() <= mostBytes && fragments.size() >= 1;
    return sane ? Optional.of(new Assembly((int) fragments.sampleSize(), fragments.size(), fragments.about(), now))
        : Optional.empty();
  }

  /** Takes fragments; false if they contradict what came before, or lie too far ahead. */
  boolean add(Fragments fragments, long now) {
    if (fragments.sampleSize() != sampleSize || fragments.size() != fragmentSize || fragments.count() < 1
        || fragments.first() < 1 || fragments.first() + fragments.count() - 1 > count) {
      return false;
    }
    int first = (int) fragments.first() - 1;
    long begin = (long) first * fragmentSize;
    int end = (int) Math.min(sampleSize, begin + (long) fragments.count() * fragmentSize);
    if (fragments.bytes().remaining() < end - begin || begin > 2L * received + AHEAD) {
      return false;
    }
    room(end);
    for (int i = first; i < first + fragments.count(); i++) {
      copy(i, fragments.bytes(), i - first);
    }
    if (fragments.about().related().isPresent()) {
      about = fragments.about();
    }
    progress = now;
    return true;
  }

  private void copy(int fragment, ByteBuffer from, int index) {
    if (seen.get(fragment)) {
      return;
    }
    int offset = fragment * fragmentSize;
    int length = Math.min(fragmentSize, sampleSize - offset);
    from.get(from.position() + index * fragmentSize, bytes, offset, length);
    seen.set(fragment);
    received += length;
  }

  private void room(int end) {
    if (end > bytes.length) {
      bytes = Arrays.copyOf(bytes, (int) grown(end));
    }
  }

  private long grown(long end) {
    return Math.min(sampleSize, Math.max(end, (long) TIMES * received + FIRST));
  }

  boolean complete() {
    return received == sampleSize;
  }

  /** The memory that it takes, or would take after these fragments. */
  long held(Fragments next) {
    long end = Math.min(sampleSize, (next.first() - 1 + next.count()) * fragmentSize);
    return Math.max(bytes.length, end <= bytes.length ? 0 : grown(end));
  }

  long held() {
    return bytes.length;
  }

  /** The bytes that came. */
  long received() {
    return received;
  }

  /** When something came that was not there. */
  long progress() {
    return progress;
  }

  /** The whole sample. */
  Change change() {
    return new Change(about.sequence(), about.kind(), ByteBuffer.wrap(bytes, 0, sampleSize).asReadOnlyBuffer(),
        about.sourceNanos(), about.related(), about.instance());
  }

  /** The first fragment from one on that did not come, from 1 on; 0 if there is none. */
  long missingFrom(long from) {
    int next = seen.nextClearBit((int) from - 1);
    return next < count ? next + 1 : 0;
  }

  /** Whether this fragment, counted from 1, has to come. */
  boolean missing(long fragment) {
    return fragment <= count && !seen.get((int) fragment - 1);
  }

  /** The last fragment that came, from 1 on. */
  long highest() {
    return seen.length();
  }

  long count() {
    return count;
  }
}
