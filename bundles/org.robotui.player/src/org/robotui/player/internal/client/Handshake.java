package org.robotui.player.internal.client;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import org.robotui.player.client.ClientOptions;
import org.robotui.player.interfaces.Server;
import org.robotui.player.layout.Kind;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** What is settled with a server before anything else: the key, the devices, when data are sent. */
final class Handshake {

  private static final int PULL = 2;
  private static final int ANY = -1;
  private static final int REPLACE = 1;

  private final Layouts layouts;
  private final ClientOptions options;

  Handshake(Layouts layouts, ClientOptions options) {
    this.layouts = layouts;
    this.options = options;
  }

  /** Answers the server's devices. */
  List<DeviceAddress> shake(Connection connection) throws IOException, PlayerException {
    if (options.key().isPresent()) {
      agree(connection, Server.AUTHENTICATE,
          layouts.question(Server.AUTHENTICATE).encode(new Server.Key(options.key().get())),
          "the server does not take the key");
    }
    PlayerMessage list = agree(connection, Server.DEVICES, ByteBuffer.allocate(0),
        "the server does not tell its devices; it may want a key");
    if (options.newestOnly()) {
      agree(connection, Server.REPLACE_RULE, layouts.question(Server.REPLACE_RULE)
          .encode(new Server.ReplaceRule(ANY, ANY, MessageType.DATA.code(), ANY, REPLACE)),
          "the server does not replace older data");
    }
    if (options.pull().isPresent()) {
      agree(connection, Server.DATA_MODE, layouts.question(Server.DATA_MODE).encode(new Server.DataMode(PULL)),
          "the server does not let data be fetched");
    }
    return layouts.answer(Server.DEVICES).decode(list.payload()).devices().stream().map(Handshake::address).toList();
  }

  private PlayerMessage agree(Connection connection, Kind.Request<?, ?> kind, ByteBuffer question, String otherwise)
      throws IOException, PlayerException {
    PlayerMessage answer =
        connection.handshake(PlayerMessage.of(connection.address(DeviceId.SERVER), MessageType.REQUEST,
            layouts.message(kind).subtype(), question));
    if (answer.type() != MessageType.ACK) {
      throw new PlayerException(otherwise);
    }
    return answer;
  }

  static DeviceAddress address(Server.Device device) {
    return new DeviceAddress((int) device.host(), (int) device.robot(), device.interfaceCode(), device.index());
  }
}
