package org.robotui.uic.status.internal;

import org.robotui.api.host.PortStatus;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Health;
import org.robotui.ui.PortLook;

/**
 * The line of a port. There may be thousands of which a few are seen: its words are made when somebody wants them.
 *
 * @param port the port
 * @param several whether there are several robot interfaces, so that its name needs theirs
 */
record PortRow(PortStatus port, boolean several) implements StatusRow.Item {
  private record Key(PortKind kind, SourceId port) {}

  @Override
  public Object key() {
    return new Key(port.kind(), port.port());
  }

  @Override
  public Health health() {
    return PortLook.health(port);
  }

  @Override
  public String name() {
    return several ? port.port().toString() : port.port().port();
  }

  @Override
  public String word() {
    return PortLook.word(port);
  }

  @Override
  public String age() {
    return PortLook.age(port);
  }

  @Override
  public String dropped() {
    return PortLook.dropped(port);
  }

  @Override
  public String value() {
    return PortLook.text(port);
  }

  @Override
  public String details() {
    return PortLook.details(port);
  }

  /** Looks at what does not change with every value, so that a line does not come and go while it is sought. */
  @Override
  public boolean says(String words) {
    return StatusRow.contains(name(), words) || StatusRow.contains(port.port().component(), words)
        || StatusRow.contains(port.kind().name(), words)
        || StatusRow.contains(port.typeName(), words) || StatusRow.contains(port.value(), words)
        || StatusRow.contains(port.problem(), words);
  }
}
