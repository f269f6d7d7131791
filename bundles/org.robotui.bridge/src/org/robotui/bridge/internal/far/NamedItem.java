package org.robotui.bridge.internal.far;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.Browser;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.CallException;
import org.robotui.api.port.PortKind;

/**
 * Finds what a bridge asks among what a robot can be asked.
 *
 * @param end names it
 * @param browser lists what there is
 */
record NamedItem(BridgeEnd end, Browser browser) {

  /** What lists the things of the robot at an end of a bridge. */
  static Optional<Browser> browser(BridgeEnd end, Ruic ruic, PortAccess access) {
    return ruic.snapshot().ports().stream()
        .filter(port -> port.kind() == PortKind.BROWSE && port.port().component().equals(end.port().component()))
        .flatMap(port -> access.browser(port.port()).stream()).findFirst();
  }

  /** One of a kind; of the other one where none of that has the name. */
  Item find(Kind kind) throws CallException {
    List<Item> found = named(kind);
    List<Item> used = found.isEmpty() ? named(other(kind)) : found;
    if (used.size() != 1) {
      String name = end.port().port();
      String word = kind == Kind.ACTION ? "action" : "service";
      throw new CallException(used.isEmpty() ? "'" + end.ruic() + "' has no " + word + " '" + name + "' now"
          : "'" + end.ruic() + "' has several " + word + "s '" + name + "': "
              + String.join(", ", used.stream().map(Item::name).toList()) + "; write the whole name");
    }
    return used.getFirst();
  }

  /** What can be asked as well. */
  static Kind other(Kind kind) {
    return kind == Kind.ACTION ? Kind.SERVICE : Kind.ACTION;
  }

  /** By its whole name, also without the slash, or by the end of it where no whole name fits. */
  private List<Item> named(Kind kind) throws CallException {
    List<Item> items = browser.list(kind);
    String name = end.port().port();
    List<Item> whole =
        items.stream().filter(i -> Stream.of(name, "/" + name).anyMatch(i.name()::equals)).limit(1).toList();
    return whole.isEmpty() ? items.stream().filter(i -> i.name().endsWith("/" + name)).toList() : whole;
  }
}
