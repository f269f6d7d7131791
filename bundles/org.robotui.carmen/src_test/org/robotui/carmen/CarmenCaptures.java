package org.robotui.carmen;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Assumptions;
import org.robotui.carmen.format.IpcFormat;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcValue;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.wire.IpcFrame;
import org.robotui.carmen.wire.IpcFraming;

/** Recorded sessions of CARMEN 0.8, shared beside the repository; tests that need them are skipped without them. */
public final class CarmenCaptures {

  /** Connections of modules to a central. */
  public static final List<String> TO_CENTRAL = List.of("base_client", "base_map", "base_param_daemon", "base_robot",
      "base_simulator", "localize_client", "localize_localize", "localize_logger", "localize_map",
      "localize_param_daemon", "localize_robot", "localize_simulator", "direct_client", "direct_map",
      "direct_param_daemon", "direct_robot", "direct_simulator");

  /** Connections between modules, with the module that listened. */
  public static final Map<String, String> DIRECT = Map.of("direct_module0_8000", "direct_param_daemon",
      "direct_module1_8004", "direct_client", "direct_module2_8004", "direct_client", "direct_module3_8002",
      "direct_simulator", "direct_module4_8003", "direct_robot");

  private static final int GREETING = 4;
  private static final IpcForm INFO = IpcForm.of("information", "*{int,string,int,format,format}",
      "info{id name kind wire content}");
  private static final IpcForm HANDLER = IpcForm.of("handler", "{int,string,string}", "id message handler");
  private static final IpcForms CARMEN = IpcForms.carmen();

  private CarmenCaptures() {}

  /** A message with the form by which it is read; of a central's own, one without a length. */
  public record Told(IpcForm form, IpcFrame frame, boolean bare) {}

  /** A file of the recordings. */
  public static Path file(String name) {
    Optional<Path> found = root().map(root -> root.resolve("captures/carmen").resolve(name)).filter(Files::isReadable);
    Assumptions.assumeTrue(found.isPresent(), "no recorded CARMEN session " + name + " (set ROBOTUI_SHARED)");
    return found.orElseThrow();
  }

  /** All bytes of a file of the recordings. */
  public static byte[] bytes(String name) {
    try {
      return Files.readAllBytes(file(name));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** What the module said that connected. */
  public static List<IpcFrame> fromModule(String connection) {
    return frames(new ByteArrayInputStream(bytes(connection + ".c2s.bin")));
  }

  /** What it heard, from a central behind its greeting. */
  public static List<IpcFrame> toModule(String connection) {
    ByteArrayInputStream in = new ByteArrayInputStream(bytes(connection + ".s2c.bin"));
    in.skip(DIRECT.containsKey(connection) ? 0 : GREETING);
    return frames(in);
  }

  private static List<IpcFrame> frames(ByteArrayInputStream in) {
    List<IpcFrame> frames = new ArrayList<>();
    try {
      while (in.available() > 0) {
        frames.add(IpcFraming.read(in));
      }
    } catch (IOException e) {
      throw new AssertionError("after " + frames.size() + " frames", e);
    }
    return frames;
  }

  /** All that was said on a connection, with what each message was found to be. */
  public static List<Told> all(String connection) throws IOException {
    boolean direct = DIRECT.containsKey(connection);
    List<IpcFrame> asked = fromModule(connection);
    List<IpcFrame> answered = toModule(connection);
    String listed = direct ? DIRECT.get(connection) : connection;
    Map<Integer, IpcRecord> known = known(listed);
    Map<Integer, String> handlers = handlers(listed);
    List<Told> told = new ArrayList<>();
    Map<Integer, Integer> queries = new HashMap<>();
    for (IpcFrame frame : asked) {
      if (frame.kind() == IpcFrame.QUERY) {
        queries.put(frame.reference(), frame.intent());
      }
      told.add(direct ? told(handlers.getOrDefault(frame.intent(), frame.name()), frame) : said(frame, known));
    }
    for (IpcFrame frame : answered) {
      told.add(direct ? told(frame.name(), frame) : heard(frame, known, handlers, queries));
    }
    return told;
  }

  private static Told said(IpcFrame frame, Map<Integer, IpcRecord> known) {
    if (frame.kind() == IpcFrame.REPLY) {
      return told(frame.name(), frame);
    }
    return frame.kind() == IpcFrame.COMPLETION ? told("", frame) : by(known.get(frame.intent()), frame, false);
  }

  private static Told heard(IpcFrame frame, Map<Integer, IpcRecord> known, Map<Integer, String> handlers,
      Map<Integer, Integer> queries) {
    boolean answer = frame.intent() == IpcFrame.REPLY_INTENT;
    if (answer && frame.kind() == IpcFrame.SYSTEM) {
      return by(known.get(queries.get(frame.reference())), frame, true);
    }
    return frame.intent() == 0 ? new Told(IpcForm.numbered("greeting", new IpcFormat.Single(
        org.robotui.carmen.format.IpcPrimitive.FORMAT)), frame, true)
        : told(answer ? frame.name() : handlers.get(frame.intent()), frame);
  }

  private static Told by(IpcRecord info, IpcFrame frame, boolean reply) {
    String name = info.text("name");
    boolean own = info.whole("kind") != IpcFrame.BROADCAST;
    if (!own) {
      return told(name, frame);
    }
    IpcFormat format = ((IpcValue.Form) info.field(reply ? "content" : "wire").orElseThrow()).format();
    return new Told(IpcForm.numbered(name, frame.body().hasRemaining() ? format : new IpcFormat.Nothing()), frame,
        true);
  }

  private static Told told(String name, IpcFrame frame) {
    return name.startsWith("V_watch_")
        ? new Told(IpcForm.of(name, "{int,<{int,int,int,int,string,string}:1>}",
            "count handlers{handler a b port host module}"), frame, true)
        : new Told(CARMEN.named(name).orElseGet(() -> IpcForm.numbered(name, new IpcFormat.Nothing())), frame,
            false);
  }

  private static Map<Integer, IpcRecord> known(String connection) throws IOException {
    Map<Integer, IpcRecord> known = new HashMap<>();
    known.put(182, new IpcRecord(INFO.fields().getFirst().members(), List.of(new IpcValue.Whole(182),
        new IpcValue.Text("x_ipc_info"), new IpcValue.Whole(IpcFrame.QUERY),
        new IpcValue.Form(IpcForm.of("", "{string,string}", "a b").format()),
        new IpcValue.Form(INFO.format()))));
    List<Integer> asked = fromModule(connection).stream()
        .filter(f -> f.kind() == IpcFrame.QUERY && f.intent() == 182).map(IpcFrame::reference).toList();
    for (IpcFrame frame : toModule(connection)) {
      boolean info = frame.kind() == IpcFrame.SYSTEM && asked.contains(frame.reference());
      if (info && INFO.readBare(frame.body()).values().getFirst() instanceof IpcValue.Members m) {
        known.put(m.record().whole("id"), m.record());
      }
    }
    return known;
  }

  private static Map<Integer, String> handlers(String connection) throws IOException {
    Map<Integer, String> handlers = new HashMap<>();
    for (IpcFrame frame : fromModule(connection)) {
      if (frame.intent() == 166) {
        IpcRecord handler = HANDLER.readBare(frame.body());
        handlers.put(handler.whole("id"), handler.text("message"));
      }
    }
    return handlers;
  }

  private static Optional<Path> root() {
    String configured = System.getenv("ROBOTUI_SHARED");
    return configured != null
        ? Optional.of(Path.of(configured))
        : repository().map(repository -> repository.resolveSibling("shared"));
  }

  private static Optional<Path> repository() {
    Path folder = Path.of("").toAbsolutePath();
    while (folder != null && !Files.isDirectory(folder.resolve("bundles"))) {
      folder = folder.getParent();
    }
    return Optional.ofNullable(folder);
  }
}
