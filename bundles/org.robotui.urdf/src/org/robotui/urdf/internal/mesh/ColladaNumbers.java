package org.robotui.urdf.internal.mesh;

import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.internal.XmlNode;

/** Numbers as the text of elements. */
final class ColladaNumbers {
  private ColladaNumbers() {}

  static FloatList floats(XmlNode node) throws Refusal {
    FloatList numbers = new FloatList();
    String text = node.text();
    int at = start(text, 0);
    while (at < text.length()) {
      int end = end(text, at);
      numbers.add(number(node, text.substring(at, end)));
      at = start(text, end);
    }
    return numbers;
  }

  /** Whole numbers from 0, appended. */
  static void indices(XmlNode node, IntList into) throws Refusal {
    String text = node.text();
    int at = start(text, 0);
    while (at < text.length()) {
      int end = end(text, at);
      try {
        into.add(Integer.parseUnsignedInt(text, at, end, 10));
      } catch (NumberFormatException e) {
        throw node.refusal("<" + node.name() + ">: '" + text.substring(at, Math.min(end, at + 40)) + "' is no index");
      }
      at = start(text, end);
    }
  }

  /** What an element of a node does to what is in it. */
  static Matrix step(XmlNode node) throws Refusal {
    int count = switch (node.name()) {
      case "matrix" -> 16;
      case "rotate" -> 4;
      default -> 3;
    };
    FloatList n = floats(node);
    if (n.size() != count) {
      throw node.refusal("<" + node.name() + "> has " + n.size() + " numbers, must have " + count);
    }
    return switch (node.name()) {
      case "matrix" -> matrix(n);
      case "rotate" -> Matrix.turned(n.get(0), n.get(1), n.get(2), Math.toRadians(n.get(3)));
      case "scale" -> Matrix.scaled(n.get(0), n.get(1), n.get(2));
      default -> Matrix.moved(n.get(0), n.get(1), n.get(2));
    };
  }

  private static Matrix matrix(FloatList n) {
    double[] rows = new double[12];
    for (int i = 0; i < 12; i++) {
      rows[i] = n.get(i);
    }
    return new Matrix(rows);
  }

  private static float number(XmlNode node, String word) throws Refusal {
    try {
      return Float.parseFloat(word.replace(',', '.'));
    } catch (NumberFormatException e) {
      throw node
          .refusal("<" + node.name() + ">: '" + word.substring(0, Math.min(word.length(), 40)) + "' is no number");
    }
  }

  private static int start(String text, int from) {
    int at = from;
    while (at < text.length() && text.charAt(at) <= ' ') {
      at++;
    }
    return at;
  }

  private static int end(String text, int from) {
    int at = from;
    while (at < text.length() && text.charAt(at) > ' ') {
      at++;
    }
    return at;
  }
}
