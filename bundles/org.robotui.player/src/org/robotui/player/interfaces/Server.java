package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** The server itself: which devices it has, and how it sends their data. The interface {@code player}. */
public final class Server {

  /** Request: devices; answered by {@link DeviceList}. */
  public static final Kind.Request<Empty, DeviceList> DEVICES =
      new Kind.Request<>("player", "devices", Empty.class, DeviceList.class);

  /** Request: driver with {@link Driver}; answered by {@link Driver}. */
  public static final Kind.Request<Driver, Driver> DRIVER =
      new Kind.Request<>("player", "driver", Driver.class, Driver.class);

  /** Request: access with {@link Access}; answered by {@link Access}. */
  public static final Kind.Request<Access, Access> ACCESS =
      new Kind.Request<>("player", "access", Access.class, Access.class);

  /** Request: data; nothing is asked with it or answered. Sends what waits, in pull mode. */
  public static final Kind.Request<Empty, Empty> DATA = new Kind.Request<>("player", "data", Empty.class, Empty.class);

  /** Request: data mode by {@link DataMode}; the answer is empty. */
  public static final Kind.Request<DataMode, Empty> DATA_MODE =
      new Kind.Request<>("player", "data_mode", DataMode.class, Empty.class);

  /** Request: authenticate by {@link Key}; the answer is empty. */
  public static final Kind.Request<Key, Empty> AUTHENTICATE =
      new Kind.Request<>("player", "authenticate", Key.class, Empty.class);

  /** Request: name service with {@link Service}; answered by {@link Service}. */
  public static final Kind.Request<Service, Service> NAME_SERVICE =
      new Kind.Request<>("player", "name_service", Service.class, Service.class);

  /** Request: replace rule by {@link ReplaceRule}; the answer is empty. */
  public static final Kind.Request<ReplaceRule, Empty> REPLACE_RULE =
      new Kind.Request<>("player", "replace_rule", ReplaceRule.class, Empty.class);

  private Server() {}

  /**
   * The address of a device.
   *
   * @param host the server's IPv4 address, first byte lowest
   * @param robot the server's port
   * @param interfaceCode the code of the interface
   * @param index the device's number among those of its interface
   */
  public record Device(long host, long robot, int interfaceCode, int index) {}

  /**
   * What a server has.
   *
   * @param devices in the server's order
   */
  public record DeviceList(List<Device> devices) {}

  /**
   * Which driver moves a device.
   *
   * @param device the device
   * @param name the driver's name; empty in questions
   */
  public record Driver(Device device, String name) {}

  /**
   * A subscription, or its end.
   *
   * @param device the device
   * @param mode 1 opens, 2 closes; in answers 3 says that it failed
   * @param driver the driver's name; empty in questions
   */
  public record Access(Device device, int mode, String driver) {}

  /**
   * When the server sends data.
   *
   * @param mode 1 push: when it comes, 2 pull: when asked
   */
  public record DataMode(int mode) {}

  /**
   * What a server with a key wants to hear before anything else.
   *
   * @param key at most 32 bytes
   */
  public record Key(byte[] key) {}

  /**
   * Another server by its name.
   *
   * @param name the robot's name
   * @param port its port; anything in questions
   */
  public record Service(String name, int port) {}

  /**
   * What becomes of a message when another of its kind waits already.
   *
   * @param interfaceCode the code of the interface, -1 for any
   * @param index the device's number, -1 for any
   * @param type the type of the message, -1 for any
   * @param subtype the message, -1 for any
   * @param replace 0 both are sent, 1 the newer replaces the older, 2 none is sent
   */
  public record ReplaceRule(int interfaceCode, int index, int type, int subtype, int replace) {}

  /**
   * The server's queue was full.
   *
   * @param dropped so many messages were lost
   */
  public record Overflow(long dropped) {}
}
