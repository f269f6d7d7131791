package org.robotui.urdf.internal;

import org.robotui.geometry.Vector3;

/** Numbers in attributes. All must be finite. */
public final class Numbers {
  private Numbers() {}

  /** One number that must be there. */
  public static double of(XmlNode node, String attribute) throws Refusal {
    return of(node, attribute, 1)[0];
  }

  /** One number, or another where there is none. */
  public static double or(XmlNode node, String attribute, double otherwise) throws Refusal {
    return node.attribute(attribute).isPresent() ? of(node, attribute) : otherwise;
  }

  /** Three numbers that must be there. */
  public static Vector3 vector(XmlNode node, String attribute) throws Refusal {
    double[] numbers = of(node, attribute, 3);
    return new Vector3(numbers[0], numbers[1], numbers[2]);
  }

  /** Three numbers, or others where there are none. */
  public static Vector3 vector(XmlNode node, String attribute, Vector3 otherwise) throws Refusal {
    return node.attribute(attribute).isPresent() ? vector(node, attribute) : otherwise;
  }

  /** So many numbers that must be there. */
  public static double[] of(XmlNode node, String attribute, int count) throws Refusal {
    double[] numbers = all(node, attribute);
    if (numbers.length != count) {
      throw node
          .refusal(attribute + "=\"" + shortened(node.required(attribute)) + "\" in <" + node.name() + "> must be "
              + (count == 1 ? "one number" : count + " numbers with blanks between them"));
    }
    return numbers;
  }

  /** Any count of numbers. */
  public static double[] all(XmlNode node, String attribute) throws Refusal {
    String[] words = node.required(attribute).split("\\s+");
    double[] numbers = new double[words.length];
    for (int i = 0; i < words.length; i++) {
      numbers[i] = number(node, attribute, words[i]);
    }
    return numbers;
  }

  private static double number(XmlNode node, String attribute, String word) throws Refusal {
    try {
      double number = Double.parseDouble(word);
      if (Double.isFinite(number)) {
        return number;
      }
    } catch (NumberFormatException e) {
      // the message below says it with its place
    }
    throw node.refusal(attribute + " in <" + node.name() + ">: '" + shortened(word) + "' is no finite number");
  }

  private static String shortened(String text) {
    return text.length() <= 60 ? text : text.substring(0, 60) + "...";
  }
}
