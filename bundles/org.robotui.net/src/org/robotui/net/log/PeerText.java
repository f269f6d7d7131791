package org.robotui.net.log;

/** What peers say, made fit for messages and logs: names and reasons may be megabytes long or hold what ends a line. */
public final class PeerText {

  private static final int MAX_TEXT = 500;
  private static final int MAX_NAME = 150;

  private PeerText() {}

  /**
   * The beginning of a text, without control characters.
   *
   * @param text of any length
   * @return at most 503 characters; control characters are spaces
   */
  public static String brief(String text) {
    return brief(text, MAX_TEXT);
  }

  /**
   * The beginning of a name or an address, short enough that what is said of its bearer is read, too.
   *
   * @param text of any length
   * @return at most 153 characters; control characters are spaces
   */
  public static String name(String text) {
    return brief(text, MAX_NAME);
  }

  private static String brief(String text, int most) {
    String start = text.length() <= most ? text : text.substring(0, most) + "...";
    return start.chars().anyMatch(Character::isISOControl) ? start.replaceAll("\\p{Cntrl}+", " ") : start;
  }
}
