package org.robotui.ui.control;

import org.robotui.api.config.Setting;

/** What a form says of a setting. Schemas have phrases and sentences; in a form all of them are sentences. */
final class HelpText {
  private HelpText() {}

  static String of(Setting setting) {
    String help = setting.help().strip();
    if (help.isEmpty()) {
      return help;
    }
    String end = Character.isLetterOrDigit(help.charAt(help.length() - 1)) || help.endsWith(")") ? "." : "";
    // An identifier is written as it is: max_linear, /scan, '*'.
    boolean word = help.matches("\\p{Lower}+[\\s,:;].*");
    return (word ? Character.toUpperCase(help.charAt(0)) + help.substring(1) : help) + end;
  }
}
