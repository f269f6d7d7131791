package org.robotui.core.internal.host;

import java.util.ArrayList;
import java.util.List;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.link.LinkState;

/** How RUICs are doing, in words for who helps. */
final class RobotFacts {
  private RobotFacts() {}

  static List<String> lines(List<? extends Ruic> ruics) {
    List<String> lines = new ArrayList<>();
    for (Ruic ruic : ruics) {
      RuicSnapshot now = ruic.snapshot();
      lines.add(now.name() + ": " + now.state() + reason(now.reason()) + ", link " + words(now.link()) + ", "
          + now.ports().size() + " ports");
      now.components().forEach(component -> lines.add("  " + words(component)));
    }
    return lines.isEmpty() ? List.of("none") : lines;
  }

  private static String words(ComponentStatus component) {
    return component.id() + " (" + component.type() + "): " + component.state() + reason(component.reason())
        + component.link().map(link -> ", link " + words(link)).orElse("");
  }

  private static String words(LinkState link) {
    return link.word() + reason(link.reason());
  }

  private static String reason(String reason) {
    return reason.isEmpty() ? "" : " (" + reason + ")";
  }
}
