package org.robotui.entity.image;

/** What became of a picture. */
public sealed interface Decoding {
  /**
   * It can be painted.
   *
   * @param picture the picture
   */
  record Decoded(Picture picture) implements Decoding {}

  /**
   * It cannot.
   *
   * @param reason a sentence for users that names what was wrong
   */
  record Undecodable(String reason) implements Decoding {}
}
