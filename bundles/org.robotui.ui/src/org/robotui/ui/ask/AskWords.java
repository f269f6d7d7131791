package org.robotui.ui.ask;

import org.robotui.api.port.Browser.Kind;

/**
 * How a view that asks speaks.
 *
 * @param kind what it lists
 * @param things what it lists, for example {@code services}
 * @param verb what its button does, for example {@code Call}
 * @param request what is filled in, for example {@code Request}
 * @param reply what comes back, for example {@code Reply}
 * @param cancels whether a question can be given up
 */
public record AskWords(Kind kind, String things, String verb, String request, String reply, boolean cancels) {
  /**
   * How many there are, in words.
   *
   * @param count zero or more
   * @return for example {@code 1 service}
   */
  public String counted(int count) {
    return count + " " + (count == 1 ? singular() : things);
  }

  /**
   * One of them as a label of its own.
   *
   * @return for example {@code Service}
   */
  String label() {
    String one = singular();
    return Character.toUpperCase(one.charAt(0)) + one.substring(1);
  }

  private String singular() {
    return things.replaceFirst("s$", "");
  }
}
