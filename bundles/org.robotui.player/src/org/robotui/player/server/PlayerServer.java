package org.robotui.player.server;

import java.io.IOException;
import java.time.Duration;
import org.robotui.player.internal.server.Acceptor;
import org.robotui.player.internal.server.Registry;
import org.robotui.player.layout.InterfaceLayout;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.DeviceId;

/**
 * A Player server. Devices may be added at any time, but clients ask for the list only when they come. Any thread may
 * use it.
 */
public final class PlayerServer implements AutoCloseable {

  private final Layouts layouts;
  private final Registry registry;
  private final Acceptor acceptor;

  /**
   * Creates a server, which listens at once.
   *
   * @param layouts the interfaces that are known
   * @param options what the server is given
   * @throws IOException if the port cannot be bound; names it
   */
  public PlayerServer(Layouts layouts, ServerOptions options) throws IOException {
    this.layouts = layouts;
    this.registry = new Registry();
    this.acceptor = new Acceptor(layouts, registry, options);
  }

  /**
   * Adds a device.
   *
   * @param interfaceName such as {@code position2d}
   * @param index its number among those of its interface
   * @param driver what clients see as the driver's name
   * @param handler what it does
   * @return the device
   * @throws IllegalArgumentException if there is no such interface, or the device is there already
   */
  public ServedDevice add(String interfaceName, int index, String driver, DeviceHandler handler) {
    InterfaceLayout known = layouts.byName(interfaceName)
        .orElseThrow(() -> new IllegalArgumentException("there is no interface '" + interfaceName + "'"));
    DeviceId id = new DeviceId(known.code(), index);
    registry.add(id, driver, handler);
    return new ServedDevice(id, registry, layouts);
  }

  /**
   * Where it listens.
   *
   * @return the port
   */
  public int port() {
    return acceptor.port();
  }

  /**
   * Waits until what was published has been written to all clients that do not fetch their data.
   *
   * @param patience how long at most
   * @return false where a client did not read it in time
   * @throws InterruptedException where the thread is interrupted
   */
  public boolean awaitSent(Duration patience) throws InterruptedException {
    return acceptor.awaitSent(patience);
  }

  /** Closes all connections, in bounded time. */
  @Override
  public void close() {
    acceptor.close();
  }
}
