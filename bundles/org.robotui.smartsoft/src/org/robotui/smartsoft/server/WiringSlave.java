package org.robotui.smartsoft.server;

import java.nio.ByteBuffer;
import java.util.Map;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.client.WiringMaster;
import org.robotui.smartsoft.internal.SmartStatus;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;

/** Lets others connect the clients of a component. */
public final class WiringSlave implements QueryServer.Handler {

  private final CommType type;
  private final Map<String, Port> ports;

  /** A client of the component. Called on the thread of whoever wires it; may block. */
  public interface Port {

    /**
     * Connects it.
     *
     * @param component that offers the service
     * @param service the service
     * @return whether it is connected now
     */
    boolean connect(String component, String service);

    /** Disconnects it. */
    void disconnect();
  }

  /**
   * Of a component.
   *
   * @param types with those of this pattern
   * @param ports its clients by name
   */
  public WiringSlave(CommTypes types, Map<String, Port> ports) {
    this.type = types.get(WiringMaster.WIRING);
    this.ports = Map.copyOf(ports);
  }

  @Override
  public ByteBuffer answer(ByteBuffer asked) throws MessageException {
    DynamicMessage said = type.read(asked);
    Port port = ports.get(said.text("slaveport").orElse(""));
    return type.bytes(Map.of("status", port == null ? SmartStatus.UNKNOWN_PORT : wire(port, said)));
  }

  private static int wire(Port port, DynamicMessage said) {
    if (said.text("command").orElse("").equals("disconnect")) {
      port.disconnect();
      return SmartStatus.OK;
    }
    return port.connect(said.text("servercomponent").orElse(""), said.text("serverservice").orElse(""))
        ? SmartStatus.OK
        : SmartStatus.UNAVAILABLE;
  }
}
