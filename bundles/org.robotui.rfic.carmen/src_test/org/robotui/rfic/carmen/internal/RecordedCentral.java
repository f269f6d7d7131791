package org.robotui.rfic.carmen.internal;

import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
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
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Assumptions;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcValue;
import org.robotui.carmen.format.FormatText;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.wire.IpcFrame;
import org.robotui.carmen.wire.IpcFraming;
import org.robotui.testkit.rfic.Peer;

/**
 * A central that answers as the real one was recorded to: with the bytes that it sent to a client and the other modules
 * of a session, by names. Numbers are taken from those bytes. What was delivered is delivered again to whoever handles
 * it, a few messages at a time.
 */
final class RecordedCentral implements Closeable {
  private static final int INFO = 182;
  private static final int CAPACITY = 4;
  private static final int FIRST_NEW = 1000;
  private static final IpcForm INFO_FORM =
      IpcForm.of("info", "*{int,string,int,format,format}", "info{id name kind wire content}");
  private static final IpcForm TWO_TEXTS = IpcForm.of("texts", "{string,string}", "name handler");
  private static final IpcForm REGISTER =
      IpcForm.of("register", "{string,int,string,string}", "name kind wire content");
  private static final IpcForm HANDLER = IpcForm.of("handler", "{int,string,string}", "id message handler");

  private final ServerSocket server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
  private final List<IpcFrame> greeting = new ArrayList<>();
  private final Map<String, ByteBuffer> infos = new ConcurrentHashMap<>(); // as the next: each module has a thread
  private final Map<Integer, String> names = new ConcurrentHashMap<>();
  private final Map<Integer, ByteBuffer> system = new HashMap<>();
  private final Map<String, List<IpcFrame>> answers = new HashMap<>();
  private final Map<String, List<ByteBuffer>> deliveries = new HashMap<>();
  private final Map<String, IpcFrame> heard = new HashMap<>();
  private final List<String> told = new CopyOnWriteArrayList<>();

  RecordedCentral(String session, List<String> modules) throws IOException {
    for (String module : modules) {
      learn(session + "_" + module);
    }
    for (IpcFrame frame : frames(session + "_map", "c2s", 0)) {
      if (frame.kind() == IpcFrame.REPLY) {
        answers.computeIfAbsent("carmen_gridmap_request", n -> new ArrayList<>()).add(frame);
      }
    }
    Peer.THREADS.newThread(this::accept).start();
  }

  private void learn(String connection) throws IOException {
    Map<Integer, Integer> asked = new HashMap<>();
    Map<Integer, String> handlers = new HashMap<>();
    for (IpcFrame frame : frames(connection, "c2s", 0)) {
      if (frame.kind() == IpcFrame.QUERY) {
        asked.put(frame.reference(), frame.intent());
      } else if (frame.intent() == 166) {
        IpcRecord handler = HANDLER.readBare(frame.body());
        handlers.put(handler.whole("id"), handler.text("message"));
      }
    }
    for (IpcFrame frame : frames(connection, "s2c", Integer.BYTES)) {
      if (frame.intent() == 0) {
        greeting.add(frame);
      } else if (frame.intent() == IpcFrame.REPLY_INTENT) {
        answer(frame, asked.getOrDefault(frame.reference(), 0));
      } else if (handlers.containsKey(frame.intent())) {
        deliveries.computeIfAbsent(handlers.get(frame.intent()), n -> new ArrayList<>()).add(frame.body());
      }
    }
  }

  private void answer(IpcFrame frame, int question) throws IOException {
    if (question == INFO) {
      if (INFO_FORM.readBare(frame.body()).values().getFirst() instanceof IpcValue.Members m) {
        infos.putIfAbsent(m.record().text("name"), frame.body());
        names.put(m.record().whole("id"), m.record().text("name"));
      }
    } else if (frame.kind() == IpcFrame.REPLY) {
      answers.computeIfAbsent(names.get(question), n -> new ArrayList<>()).add(frame);
    } else {
      system.put(question, frame.body());
    }
  }

  private static List<IpcFrame> frames(String connection, String way, int skipped) throws IOException {
    ByteArrayInputStream in = new ByteArrayInputStream(Files.readAllBytes(file(connection + "." + way + ".bin")));
    in.skip(skipped);
    List<IpcFrame> frames = new ArrayList<>();
    while (in.available() > 0) {
      frames.add(IpcFraming.read(in));
    }
    return frames;
  }

  private static Path file(String name) {
    Optional<Path> found = Optional.ofNullable(System.getenv("ROBOTUI_SHARED"))
        .map(root -> Path.of(root, "captures/carmen", name)).filter(Files::isReadable);
    Assumptions.assumeTrue(found.isPresent(), "no recorded CARMEN session " + name + " (set ROBOTUI_SHARED)");
    return found.orElseThrow();
  }

  /** What nobody registered in the recording gets a number that nothing there has. */
  private synchronized void register(IpcRecord message) throws IOException {
    String name = message.text("name");
    if (!infos.containsKey(name)) {
      int id = FIRST_NEW + names.size();
      IpcRecord info = new IpcRecord(INFO_FORM.fields().getFirst().members(),
          List.of(new IpcValue.Whole(id), new IpcValue.Text(name), new IpcValue.Whole(message.whole("kind")),
              new IpcValue.Form(FormatText.parse(message.text("wire"))),
              new IpcValue.Form(FormatText.parse(message.text("content")))));
      names.put(id, name);
      infos.put(name, ByteBuffer.wrap(INFO_FORM.writeBare(
          new IpcRecord(INFO_FORM.fields(), List.of(new IpcValue.Members(info))), ByteOrder.LITTLE_ENDIAN)));
    }
  }

  int port() {
    return server.getLocalPort();
  }

  /** The latest message of a name that somebody sent. */
  synchronized Optional<IpcFrame> heard(String message) {
    return Optional.ofNullable(heard.get(message));
  }

  /** What nobody sends to a real central. */
  List<String> complaints() {
    return told;
  }

  private void accept() {
    try {
      while (true) {
        Socket socket = server.accept();
        Peer.THREADS.newThread(() -> serve(socket)).start();
      }
    } catch (IOException e) {
      // closed
    }
  }

  private void serve(Socket socket) {
    try (socket) {
      OutputStream out = socket.getOutputStream();
      out.write(ByteBuffer.allocate(Integer.BYTES).putInt(INFO).array());
      for (IpcFrame frame : greeting.subList(0, 2)) {
        out.write(IpcFraming.bytes(frame));
      }
      new Link(socket.getInputStream(), out).follow();
    } catch (IOException e) {
      // the module is gone
    }
  }

  /** One module. */
  private final class Link {
    private final InputStream in;
    private final OutputStream out;
    private final ArrayDeque<IpcFrame> waiting = new ArrayDeque<>();
    private int outstanding;
    private int references;

    Link(InputStream in, OutputStream out) {
      this.in = in;
      this.out = out;
    }

    void follow() throws IOException {
      while (true) {
        IpcFrame frame = IpcFraming.read(in);
        if (frame.kind() == IpcFrame.COMPLETION) {
          outstanding--;
        } else if (frame.intent() == INFO) {
          reply(frame, infos.getOrDefault(TWO_TEXTS.readBare(frame.body()).text("name"), ByteBuffer.allocate(1)));
        } else if (system.containsKey(frame.intent())) {
          reply(frame, system.get(frame.intent()));
        } else {
          programs(frame);
        }
        deliver();
      }
    }

    private void programs(IpcFrame frame) throws IOException {
      String name = names.getOrDefault(frame.intent(), "");
      if (name.isEmpty()) {
        told.add("a message of the number " + frame.intent());
      }
      synchronized (RecordedCentral.this) {
        heard.put(name, frame);
      }
      if (frame.intent() == 168) {
        register(REGISTER.readBare(frame.body()));
      } else if (frame.intent() == 166) {
        IpcRecord handler = HANDLER.readBare(frame.body());
        if (handler.whole("id") > 0) {
          begin(handler.whole("id"), handler.text("message"));
        }
      } else if (frame.kind() == IpcFrame.QUERY && answers.containsKey(name)) {
        IpcFrame said = answers.get(name).getFirst();
        out.write(IpcFraming.bytes(new IpcFrame(0, IpcFrame.REPLY_INTENT, IpcFrame.REPLY, 0, frame.reference(),
            said.name(), ByteOrder.LITTLE_ENDIAN, said.body())));
      }
    }

    private void begin(int handler, String message) {
      String name = message;
      for (ByteBuffer body : deliveries.getOrDefault(message, List.of())) {
        waiting.add(new IpcFrame(IpcFrame.NONE, handler, IpcFrame.BROADCAST, IpcFrame.NONE, references++, name,
            ByteOrder.LITTLE_ENDIAN, body));
        name = "";
      }
    }

    private void deliver() throws IOException {
      while (outstanding < CAPACITY && !waiting.isEmpty()) {
        outstanding++;
        out.write(IpcFraming.bytes(waiting.remove()));
      }
    }

    private void reply(IpcFrame question, ByteBuffer body) throws IOException {
      out.write(IpcFraming.bytes(new IpcFrame(0, IpcFrame.REPLY_INTENT, IpcFrame.SYSTEM, 0, question.reference(), "",
          ByteOrder.LITTLE_ENDIAN, body)));
    }
  }

  @Override
  public void close() throws IOException {
    server.close();
  }
}
