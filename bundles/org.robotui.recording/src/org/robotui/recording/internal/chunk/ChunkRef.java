package org.robotui.recording.internal.chunk;

import java.util.Arrays;
import java.util.Map;

/** A part of a file with messages, as the index has it. */
public final class ChunkRef {

  /** Where a count is not known. */
  public static final long UNKNOWN = -1;

  private final long offset;
  private final long length;
  private final long start;
  private final long end;
  private final long messages;
  private final int[] channels;

  private ChunkRef(long offset, long length, long start, long end, long messages, int[] channels) {
    this.offset = offset;
    this.length = length;
    this.start = start;
    this.end = end;
    this.messages = messages;
    this.channels = channels;
    Arrays.sort(channels);
  }

  /**
   * @param offset where its record begins, with its length where the format knows it before it is read
   * @param start the first log time in it, with the last one
   * @param channels those that have messages in it
   */
  public static ChunkRef of(long offset, long length, long start, long end, long messages, int[] channels) {
    return new ChunkRef(offset, length, start, end, messages, channels.clone());
  }

  /** The same chunk of a recording that has several files. */
  ChunkRef renumbered(long place, Map<Integer, Integer> numbers) {
    return new ChunkRef(place, length, start, end, messages,
        Arrays.stream(channels).filter(numbers::containsKey).map(numbers::get).toArray());
  }

  public long offset() {
    return offset;
  }

  public long length() {
    return length;
  }

  public long start() {
    return start;
  }

  public long end() {
    return end;
  }

  public long messages() {
    return messages;
  }

  public boolean has(int channel) {
    return Arrays.binarySearch(channels, channel) >= 0;
  }

  public boolean hasAny(int[] wanted) {
    return Arrays.stream(wanted).anyMatch(this::has);
  }
}
