package org.robotui.player.log;

import java.util.List;

/** A part of a line of a log file. */
sealed interface LinePart {

  /** One number. */
  record Scalar(String path, NumberFormat format) implements LinePart {}

  /** The length of an array. */
  record Length(String array, NumberFormat format) implements LinePart {}

  /** A number of an element of an array; the path is empty if the elements are numbers. */
  record Element(String array, String path, NumberFormat format) implements LinePart {}

  /** What follows for each element of the array whose length stands before. */
  record Each(List<Element> parts) implements LinePart {}

  /** Bytes in hexadecimal digits. */
  record Hex(String path) implements LinePart {}
}
