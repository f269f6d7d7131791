package org.robotui.smartsoft.client;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.internal.SmartStatus;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;

/** Connects clients of another component to services. All of it blocks. */
public final class WiringMaster {

  /** The object of this pattern, request and answer, by which its services are known. */
  public static final String WIRING = "SmartACE::smartWiring";

  private final QueryClient client;
  private final CommType type;
  private final Duration patience;

  /**
   * Of a service.
   *
   * @param client connected to the wiring of a component
   * @param types with those of this pattern
   * @param patience how long an answer may take; a component answers when it is connected
   */
  public WiringMaster(QueryClient client, CommTypes types, Duration patience) {
    this.client = client;
    this.type = types.get(WIRING);
    this.patience = patience;
  }

  /**
   * Connects a client.
   *
   * @param port the client's port, as its component calls it
   * @param component that offers the service
   * @param service the service
   * @throws IOException where it is not connected, with the reason
   */
  public void connect(String port, String component, String service) throws IOException {
    ask("connect", port, component, service);
  }

  /**
   * Disconnects a client.
   *
   * @param port the client's port
   * @throws IOException where it cannot
   */
  public void disconnect(String port) throws IOException {
    ask("disconnect", port, "", "");
  }

  private void ask(String command, String port, String component, String service) throws IOException {
    try {
      int status = (int) type.read(client.query(type.bytes(Map.of("command", command, "slaveport", port,
          "servercomponent", component, "serverservice", service)), patience)).number("status").orElseThrow();
      if (status != SmartStatus.OK) {
        throw new IOException(port + " cannot " + command + ": " + SmartStatus.text(status));
      }
    } catch (MessageException e) {
      throw new IOException("the answer cannot be read: " + e.getMessage(), e);
    }
  }
}
