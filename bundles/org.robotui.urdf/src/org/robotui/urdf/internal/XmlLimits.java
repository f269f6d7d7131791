package org.robotui.urdf.internal;

/** How large a document may be. */
public record XmlLimits(long characters, int depth, int elements) {
  /** Descriptions of robots. */
  public static final XmlLimits DESCRIPTION = new XmlLimits(16_000_000, 64, 500_000);

  /** Files of meshes: much text in few elements, or an element a polygon. */
  public static final XmlLimits MESH = new XmlLimits(256_000_000, 128, 1_000_000);
}
