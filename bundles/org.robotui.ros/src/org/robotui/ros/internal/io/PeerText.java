package org.robotui.ros.internal.io;

/** What peers say, made fit for messages and logs: names and reasons may be megabytes long or hold what ends a line. */
public final class PeerText {

  private static final int MOST = 500;
  private static final int MOST_OF_NAME = 150;

  private PeerText() {
  }

  /** The beginning of a text, without control characters. */
  public static String brief(String text) {
    return brief(text, MOST);
  }

  /** The beginning of a name or an address, short enough that what is said of its bearer is read, too. */
  public static String name(String text) {
    return brief(text, MOST_OF_NAME);
  }

  private static String brief(String text, int most) {
    String start = text.length() <= most ? text : text.substring(0, most) + "...";
    return start.chars().anyMatch(Character::isISOControl) ? start.replaceAll("\\p{Cntrl}+", " ") : start;
  }
}
