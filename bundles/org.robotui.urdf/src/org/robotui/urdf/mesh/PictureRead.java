package org.robotui.urdf.mesh;

/** What came of reading a picture. */
public sealed interface PictureRead {
  /**
   * It was read.
   *
   * @param picture its pixels
   */
  record Ok(Picture picture) implements PictureRead {}

  /**
   * It cannot be used.
   *
   * @param why what is wrong
   */
  record Refused(String why) implements PictureRead {}
}
