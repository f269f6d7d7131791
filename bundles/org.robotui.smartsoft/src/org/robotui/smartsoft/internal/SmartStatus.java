package org.robotui.smartsoft.internal;

import java.util.List;
import java.util.Locale;

/** What numbers of a status mean. Older releases count regular ones from 257, newer ones from 1, in another order. */
public final class SmartStatus {

  /** All is well. */
  public static final int OK = 0;
  /** What is asked for is no known state. */
  public static final int UNKNOWN_STATE = 5;
  /** It may not be done. */
  public static final int NOT_ALLOWED = 8;
  /** There is no such port. */
  public static final int UNKNOWN_PORT = 14;
  /** There is no such service. */
  public static final int UNAVAILABLE = 15;

  private static final int ERRORS = 512;
  private static final List<String> REGULAR = List.of("ok", "no data", "cancelled", "unsubscribed", "wrong id",
      "unknown state", "not activated", "activated", "not allowed", "active", "passive", "disconnected",
      "incompatible service", "port already used", "unknown port", "service unavailable", "unknown component",
      "timeout");
  private static final List<String> BAD = List.of("error", "error of communication", "unknown error", "fatal error");

  private SmartStatus() {}

  /** In words, with the number. */
  public static String text(int status) {
    List<String> words = status >= ERRORS ? BAD : REGULAR;
    int index = status >= ERRORS ? status - ERRORS : status;
    return index >= 0 && index < words.size()
        ? words.get(index) + " (" + status + ")"
        : String.format(Locale.ROOT, "status %d", status);
  }
}
