package org.robotui.ui;

import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;

/** How links and components look, the same in all views that list them. Pure, for all threads. */
public final class LinkLook {
  private LinkLook() {}

  /**
   * The dot of a link.
   *
   * @param link the link
   * @return its health
   */
  public static Health health(LinkState link) {
    return switch (link) {
      case LinkState.Connected c -> Health.OK;
      case LinkState.Degraded d -> Health.WARNING;
      case LinkState.Connecting c -> Health.WAITING;
      case LinkState.Failed f -> Health.BAD;
      case LinkState.Disconnected d -> Health.NONE;
    };
  }

  /**
   * What is to be said of a link: with whom where all is well, else why not.
   *
   * @param link the link
   * @return a sentence, or empty
   */
  public static String text(LinkState link) {
    return link instanceof LinkState.Connected connected ? connected.peer() : link.reason();
  }

  /**
   * The dot of a component: bad where it failed, else that of its link; a view without a fault is well.
   *
   * @param component the component
   * @return its health
   */
  public static Health health(ComponentStatus component) {
    return component.state() == RuicState.FAILED
        ? Health.BAD
        : component.link().map(LinkLook::health).orElse(Health.OK);
  }

  /**
   * The word of a component.
   *
   * @param component the component
   * @return {@code failed}, or the word of its link, or empty where it has none
   */
  public static String word(ComponentStatus component) {
    return component.state() == RuicState.FAILED ? "failed" : component.link().map(LinkState::word).orElse("");
  }

  /**
   * What is to be said of a component.
   *
   * @param component the component
   * @return why it failed, or the text of its link, or empty
   */
  public static String text(ComponentStatus component) {
    return component.state() == RuicState.FAILED ? component.reason() : component.link().map(LinkLook::text).orElse("");
  }

  /**
   * What a component is called.
   *
   * @param component the component
   * @return its id, and its type where that says more
   */
  public static String name(ComponentStatus component) {
    boolean typed = component.kind() == ComponentStatus.Kind.RFIC || !component.type().equals(component.id());
    return typed ? component.id() + " \u00b7 " + component.type() : component.id();
  }
}
