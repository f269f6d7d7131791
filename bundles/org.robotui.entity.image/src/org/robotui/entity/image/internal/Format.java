package org.robotui.entity.image.internal;

import java.util.Optional;
import org.robotui.data.image.PixelEncoding;

/**
 * What the format of a compressed picture of ROS says, for example {@code 16UC1; compressedDepth png} or plainly
 * {@code jpeg}.
 *
 * @param source the encoding before it was compressed, where that is named
 * @param depth whether it comes with the header of compressed depth
 * @param rvl whether depth is compressed as RVL
 */
record Format(Optional<PixelEncoding> source, boolean depth, boolean rvl) {
  static Format of(String text) {
    int end = text.indexOf(';');
    Optional<PixelEncoding> source = PixelEncoding.fromRos(end < 0 ? text.strip() : text.substring(0, end).strip());
    boolean depth = text.contains("compressedDepth");
    return new Format(source, depth, depth && text.contains("rvl"));
  }

  /** The encoding of a picture of one channel that was inside. */
  PixelEncoding oneChannel(PixelEncoding usual) {
    return source.filter(s -> s.channels() == 1 && s.sample() == usual.sample()).orElse(usual);
  }
}
