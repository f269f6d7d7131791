package org.robotui.player.client;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.robotui.net.call.Outcome;
import org.robotui.player.interfaces.Server;
import org.robotui.player.internal.client.ClientRuntime;
import org.robotui.player.layout.InterfaceLayout;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;

/**
 * A client of one Player server. It begins to connect when it is made, and connects anew whenever the link is lost;
 * what was subscribed is opened again then. It has two threads, one that receives and one that sends. Any thread may
 * use it, and no call but {@link #close} waits.
 */
public final class PlayerClient implements AutoCloseable {

  private final ClientRuntime runtime;

  /**
   * Creates a client and begins to connect.
   *
   * @param host the server's name or address
   * @param port the server's port, by custom 6665
   * @param layouts the interfaces that are known
   * @param options what the client is given
   */
  public PlayerClient(String host, int port, Layouts layouts, ClientOptions options) {
    this.runtime = new ClientRuntime(host, port, layouts, options);
  }

  /**
   * The state of the link.
   *
   * @return the present state
   */
  public LinkState state() {
    return runtime.state();
  }

  /**
   * The server's devices.
   *
   * @return as it told when the link was last made; empty before
   */
  public List<DeviceAddress> devices() {
    return runtime.listed();
  }

  /**
   * One of the devices, whether the server has it or not.
   *
   * @param id interface and index
   * @return the device
   */
  public PlayerDevice device(DeviceId id) {
    return new PlayerDevice(runtime.device(id));
  }

  /**
   * One of the devices, whether the server has it or not.
   *
   * @param interfaceName such as {@code position2d}
   * @param index its number among those of its interface
   * @return the device
   * @throws IllegalArgumentException if there is no layout of the interface
   */
  public PlayerDevice device(String interfaceName, int index) {
    InterfaceLayout known = runtime.layouts().byName(interfaceName)
        .orElseThrow(() -> new IllegalArgumentException("there is no interface '" + interfaceName + "'"));
    return device(new DeviceId(known.code(), index));
  }

  /**
   * The server itself, for its own requests.
   *
   * @return the device {@code player:0}
   */
  public PlayerDevice server() {
    return device(DeviceId.SERVER);
  }

  /**
   * Which driver moves a device.
   *
   * @param device one of {@link #devices}
   * @return the driver's name, or why there is none
   */
  public CompletableFuture<Outcome<String>> driver(DeviceAddress device) {
    Server.Device asked =
        new Server.Device(Integer.toUnsignedLong(device.host()), Integer.toUnsignedLong(device.robot()),
            device.interfaceCode(), device.index());
    return server().request(Server.DRIVER, new Server.Driver(asked, ""))
        .thenApply(outcome -> outcome.map(Server.Driver::name));
  }

  /**
   * How many messages the server lost because this client was slow.
   *
   * @return the sum of what the server told, over all links so far
   */
  public long overflows() {
    return runtime.overflows();
  }

  /**
   * How many messages came of devices that nobody asked for.
   *
   * @return over all links so far
   */
  public long unexpected() {
    return runtime.unexpected();
  }

  /**
   * How many commands were replaced by newer ones before the network took them.
   *
   * @return on the present link
   */
  public long replacedCommands() {
    return runtime.replaced();
  }

  /**
   * Ends the link in bounded time, about two seconds at most. What was commanded just before is sent if the network
   * takes it.
   */
  @Override
  public void close() {
    runtime.close();
  }
}
