package org.robotui.player.internal.server;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.util.Optional;
import org.robotui.player.interfaces.Server;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.Answer;
import org.robotui.player.server.TypedHandler;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/**
 * What a client asks the server itself. Without the key, if the server has one, everything is refused. For one thread.
 */
final class ServerRequests {

  private static final int OPEN = 1;
  private static final int CLOSE = 2;
  private static final int ERROR = 3;
  private static final int PUSH = 1;
  private static final int PULL = 2;

  private final Layouts layouts;
  private final Registry registry;
  private final ClientSession client;
  private final SendQueue out;
  private final Optional<byte[]> key;
  private final TypedHandler strange;
  private final TypedHandler trusted;
  private final int access;
  private final int fetch;
  private boolean trusts;

  ServerRequests(Layouts layouts, Registry registry, ClientSession client, SendQueue out, Optional<byte[]> key) {
    this.layouts = layouts;
    this.registry = registry;
    this.client = client;
    this.out = out;
    this.key = key;
    this.trusts = key.isEmpty();
    this.access = layouts.message(Server.ACCESS).subtype();
    this.fetch = layouts.message(Server.DATA).subtype();
    this.strange = new TypedHandler(layouts, none -> {}).on(Server.AUTHENTICATE, this::authenticate);
    this.trusted = new TypedHandler(layouts, none -> {})
        .on(Server.AUTHENTICATE, this::authenticate)
        .on(Server.DEVICES, none -> Optional.of(devices()))
        .on(Server.DRIVER, this::driver)
        .on(Server.DATA_MODE, mode -> mode(mode.mode()))
        .on(Server.REPLACE_RULE, rule -> Optional.of(new Empty()).filter(none -> out.rule(rule)));
  }

  /** Whether data are fetched, which needs more than an answer. */
  boolean isFetch(PlayerMessage request) {
    return trusts && request.subtype() == fetch;
  }

  Answer answer(PlayerMessage request) {
    if (!trusts) {
      return strange.onRequest(request);
    }
    return request.subtype() == access ? access(request) : trusted.onRequest(request);
  }

  private Optional<Empty> authenticate(Server.Key said) {
    trusts |= key.filter(wanted -> MessageDigest.isEqual(wanted, said.key())).isPresent();
    return Optional.of(new Empty()).filter(none -> trusts);
  }

  private Server.DeviceList devices() {
    return new Server.DeviceList(registry.all().stream().map(id -> device(client.address(id))).toList());
  }

  private static Server.Device device(DeviceAddress address) {
    return new Server.Device(Integer.toUnsignedLong(address.host()), Integer.toUnsignedLong(address.robot()),
        address.interfaceCode(),
        address.index());
  }

  private Optional<Server.Driver> driver(Server.Driver asked) {
    return registry.driver(id(asked.device())).map(name -> new Server.Driver(asked.device(), name));
  }

  private Optional<Empty> mode(int mode) {
    boolean known = mode == PUSH || mode == PULL;
    if (known) {
      out.pull(mode == PULL);
    }
    return Optional.of(new Empty()).filter(none -> known);
  }

  private Answer access(PlayerMessage request) {
    try {
      return access(layouts.question(Server.ACCESS).decode(request.payload()));
    } catch (PlayerException e) {
      return Answer.refused();
    }
  }

  private Answer access(Server.Access asked) {
    DeviceId id = id(asked.device());
    Optional<String> driver = registry.driver(id);
    if (driver.isEmpty() || asked.mode() != OPEN && asked.mode() != CLOSE) {
      return new Answer.Nack(encoded(new Server.Access(asked.device(), ERROR, "")));
    }
    boolean wasOpen = registry.isOpen(id, client);
    if (asked.mode() == OPEN) {
      registry.open(id, client);
    } else {
      registry.close(id, client);
    }
    int mode = asked.mode() == OPEN || wasOpen ? asked.mode() : ERROR;
    return new Answer.Ack(encoded(new Server.Access(asked.device(), mode, driver.get())));
  }

  private ByteBuffer encoded(Server.Access granted) {
    return layouts.answer(Server.ACCESS).encode(granted);
  }

  private static DeviceId id(Server.Device device) {
    return new DeviceId(device.interfaceCode(), device.index());
  }
}
