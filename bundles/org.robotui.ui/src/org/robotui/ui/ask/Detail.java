package org.robotui.ui.ask;

import org.robotui.api.port.Browser.Description;

/** What a robot says about something that it has. */
public sealed interface Detail {
  /**
   * What it is about.
   *
   * @return the entry of the catalogue
   */
  Catalogue.Entry entry();

  /**
   * It was asked for; no answer yet.
   *
   * @param entry what it is about
   */
  record Asked(Catalogue.Entry entry) implements Detail {}

  /**
   * The robot described it.
   *
   * @param entry what it is about
   * @param description the description
   */
  record Known(Catalogue.Entry entry, Description description) implements Detail {}

  /**
   * The robot did not.
   *
   * @param entry what it is about
   * @param reason a sentence for users
   */
  record Unknown(Catalogue.Entry entry, String reason) implements Detail {}
}
