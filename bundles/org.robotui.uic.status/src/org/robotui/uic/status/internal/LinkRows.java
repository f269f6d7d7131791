package org.robotui.uic.status.internal;

import java.util.stream.Stream;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicState;
import org.robotui.ui.LinkLook;

/** Lines of links, and of components that failed. */
final class LinkRows {
  private LinkRows() {}

  static Stream<StatusRow> of(ComponentStatus component) {
    boolean shown = component.state() == RuicState.FAILED || component.link().isPresent();
    return shown ? Stream.of(row(component)) : Stream.empty();
  }

  private static StatusRow row(ComponentStatus component) {
    String name = component.kind() == ComponentStatus.Kind.RFIC ? LinkLook.name(component) : component.id();
    String word = LinkLook.word(component);
    String text = LinkLook.text(component);
    return new StatusRow.Said("component " + component.id(), LinkLook.health(component), name, word, text,
        name + "\n" + word + "\n" + text);
  }
}
