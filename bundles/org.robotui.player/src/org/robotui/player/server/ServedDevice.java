package org.robotui.player.server;

import java.nio.ByteBuffer;
import org.robotui.player.internal.server.Registry;
import org.robotui.player.layout.Kind;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.wire.DeviceId;

/** A device of a server. Any thread may use it; nothing waits for a client. */
public final class ServedDevice {

  private final DeviceId id;
  private final Registry registry;
  private final Layouts layouts;

  ServedDevice(DeviceId id, Registry registry, Layouts layouts) {
    this.id = id;
    this.registry = registry;
    this.layouts = layouts;
  }

  /**
   * Which device it is.
   *
   * @return interface and index
   */
  public DeviceId id() {
    return id;
  }

  /**
   * Sends data to all clients that have the device open.
   *
   * @param kind the kind
   * @param value the data
   * @param stamp when they were measured, seconds
   * @param <T> their record
   */
  public <T> void publish(Kind.Data<T> kind, T value, double stamp) {
    if (clients() > 0) {
      publish(layouts.message(kind).subtype(), layouts.codec(kind).encode(value), stamp);
    }
  }

  /**
   * Sends data to all clients that have the device open.
   *
   * @param message which data
   * @param value the data
   * @param stamp when they were measured, seconds
   */
  public void publish(MessageLayout message, PlayerRecord value, double stamp) {
    publish(message.subtype(), layouts.encode(value), stamp);
  }

  /**
   * Sends data to all clients that have the device open.
   *
   * @param subtype which data
   * @param payload their body
   * @param stamp when they were measured, seconds
   */
  public void publish(int subtype, ByteBuffer payload, double stamp) {
    registry.publish(id, subtype, payload, stamp);
  }

  /**
   * How many clients have the device open.
   *
   * @return the number now
   */
  public int clients() {
    return registry.clients(id);
  }
}
