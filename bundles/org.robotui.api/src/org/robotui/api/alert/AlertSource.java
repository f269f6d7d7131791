package org.robotui.api.alert;

/** Where a view says what it noticed. Its alerts end with it. Safe for all threads; never blocks. */
public interface AlertSource {
  /**
   * Begins an alert, or says what is seen now of one that is on.
   *
   * @param name what users call it, unique in the view
   * @param condition when it is due, as configured
   * @param source what it was seen at
   * @param value what was seen there
   */
  void raise(String name, String condition, String source, String value);

  /**
   * The condition holds no more. The alert stays listed until it is acknowledged.
   *
   * @param name of the alert; one that is not on is left as it is
   */
  void end(String name);

  /**
   * Whether an alert may be heard.
   *
   * @param name of the alert
   * @return false while it is acknowledged or muted, alone or with all
   */
  boolean isHeard(String name);
}
