package org.robotui.rfic.smartsoft.internal;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import org.junit.jupiter.api.Assumptions;
import org.robotui.message.CdrReader;
import org.robotui.message.CdrWriter;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.wire.NamingCommand;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;
import org.robotui.smartsoft.wire.SmartFraming;
import org.robotui.testkit.rfic.Peer;

/**
 * A naming service and servers that answer with the bytes of recorded ones. Only the ports in the entries of the naming
 * service are other ones; a client has to say the identifiers that were recorded.
 */
final class RecordedServers implements AutoCloseable {
  private static final SmartFraming FRAMING = new SmartFraming();

  private final List<ServerSocket> open = new ArrayList<>();
  private final Map<String, Integer> ports = new HashMap<>();
  private final int port;

  /** Entries of a recorded list, and the files of their services by the names of services. */
  RecordedServers(String listing, Map<String, String> services) throws IOException {
    for (Map.Entry<String, String> service : services.entrySet()) {
      List<SmartFrame> asked = frames(service.getValue() + ".c2s");
      List<SmartFrame> said = frames(service.getValue() + ".s2c");
      ports.put(service.getKey(), listen(socket -> new Replay(asked, said).talk(socket)));
    }
    List<SmartFrame> entries = frames(listing).stream()
        .filter(frame -> frame.command() == NamingCommand.LIST || frame.command() == NamingCommand.END_OF_LIST)
        .toList();
    port = listen(socket -> list(socket, entries));
  }

  int port() {
    return port;
  }

  static List<SmartFrame> frames(String file) {
    String shared = Optional.ofNullable(System.getenv("ROBOTUI_SHARED")).orElse("../../../shared");
    Path found = Path.of(shared, "captures/smartsoft", file + ".bin");
    Assumptions.assumeTrue(Files.isReadable(found), "no recorded SmartSoft session (set ROBOTUI_SHARED)");
    List<SmartFrame> frames = new ArrayList<>();
    try {
      ByteArrayInputStream in = new ByteArrayInputStream(Files.readAllBytes(found));
      while (in.available() > 0) {
        frames.add(FRAMING.read(in));
      }
      return frames;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private interface Talking {
    void talk(Socket socket) throws IOException, MessageException;
  }

  private int listen(Talking talking) throws IOException {
    ServerSocket server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    open.add(server);
    Peer.THREADS.newThread(() -> {
      try {
        while (true) {
          Socket socket = server.accept();
          Peer.THREADS.newThread(() -> talk(talking, socket)).start();
        }
      } catch (IOException e) {
        // closed
      }
    }).start();
    return server.getLocalPort();
  }

  private static void talk(Talking talking, Socket socket) {
    try (socket) {
      talking.talk(socket);
    } catch (IOException | MessageException e) {
      // the client is gone
    }
  }

  private void list(Socket socket, List<SmartFrame> entries) throws IOException, MessageException {
    while (FRAMING.read(socket.getInputStream()).command() == NamingCommand.LIST) {
      for (SmartFrame entry : entries) {
        socket.getOutputStream().write(FRAMING.bytes(moved(entry)));
      }
    }
  }

  private SmartFrame moved(SmartFrame entry) throws IOException, MessageException {
    if (entry.command() != NamingCommand.LIST) {
      return entry;
    }
    CdrReader said = entry.reader();
    String name = said.string("name");
    ServiceAddress address = ServiceAddress.parse(said.string("value"));
    int moved = ports.entrySet().stream().filter(each -> name.contains("<" + each.getKey() + ">"))
        .map(Map.Entry::getValue).findFirst().orElse(address.at().port());
    CdrWriter out = SmartFrame.data();
    out.string(name).string("127.0.0.1:" + moved + "#" + address.identifier()).string(said.string("type"));
    return new SmartFrame(entry.command(), ByteOrder.LITTLE_ENDIAN, out.view(), ByteBuffer.allocate(0));
  }

  /** Says after each kind of question what was recorded after it. */
  private static final class Replay {
    private final SmartFrame connect;
    private final List<SmartFrame> said;
    private final Map<ByteBuffer, SmartFrame> answers = new HashMap<>();

    Replay(List<SmartFrame> asked, List<SmartFrame> said) {
      this.connect = asked.getFirst();
      this.said = said;
      Queue<SmartFrame> waiting = new ArrayDeque<>();
      said.stream().filter(each -> is(each, SmartCommand.ANSWER)).forEach(waiting::add);
      asked.stream().filter(each -> is(each, SmartCommand.REQUEST) && !waiting.isEmpty())
          .forEach(each -> answers.putIfAbsent(each.object(), waiting.remove()));
    }

    private static boolean is(SmartFrame frame, SmartCommand command) {
      return frame.command() == command.number();
    }

    void talk(Socket socket) throws IOException {
      while (true) {
        SmartFrame frame = FRAMING.read(socket.getInputStream());
        for (SmartFrame answer : answers(frame)) {
          socket.getOutputStream().write(FRAMING.bytes(answer));
        }
      }
    }

    private List<SmartFrame> answers(SmartFrame frame) {
      return switch (SmartCommand.of(frame.command()).orElseThrow()) {
        case CONNECT -> frame.pattern().equals(connect.pattern()) ? kinds(SmartCommand.ACK_CONNECT) : List.of();
        case SUBSCRIBE -> said.stream().filter(each -> is(each, SmartCommand.ACK_SUBSCRIBE)
            || is(each, SmartCommand.UPDATE) && each.pattern().getInt(0) == 1).toList();
        case ACTIVATE -> said.stream()
            .filter(each -> is(each, SmartCommand.ACK_ACTIVATE) || is(each, SmartCommand.EVENT)).toList();
        case REQUEST -> Optional.ofNullable(answers.get(frame.object()))
            .map(each -> new SmartFrame(each.command(), each.order(), frame.pattern(), each.object())).stream()
            .toList();
        case DISCONNECT -> kinds(SmartCommand.ACK_DISCONNECT);
        default -> List.of();
      };
    }

    private List<SmartFrame> kinds(SmartCommand command) {
      return said.stream().filter(each -> is(each, command)).limit(1).toList();
    }
  }

  @Override
  public void close() throws IOException {
    for (ServerSocket each : open) {
      each.close();
    }
  }
}
