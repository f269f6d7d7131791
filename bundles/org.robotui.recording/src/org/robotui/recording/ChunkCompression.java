package org.robotui.recording;

/** How a recorder makes chunks smaller. */
public enum ChunkCompression {
  /** Not at all. */
  NONE(""),
  /** Fast. */
  LZ4("lz4"),
  /** Smaller than LZ4, and slower. */
  ZSTD("zstd");

  private final String word;

  ChunkCompression(String word) {
    this.word = word;
  }

  /**
   * The word for it in MCAP.
   *
   * @return empty for none
   */
  public String word() {
    return word;
  }
}
