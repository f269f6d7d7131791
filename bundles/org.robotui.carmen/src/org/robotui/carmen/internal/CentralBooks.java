package org.robotui.carmen.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.robotui.carmen.format.FormatText;
import org.robotui.carmen.format.IpcFormat;
import org.robotui.carmen.format.IpcFormatException;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcValue;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.wire.IpcFrame;

/** What a central knows: messages, who handles them, and questions that wait for answers. Safe for all threads. */
public final class CentralBooks {

  /** The number of the question for what is known of a message, which a central says first. */
  public static final int INFO_ID = 182;

  private static final int MOST_MESSAGES = 4096;
  private static final int FIRST_ID = 200;
  private static final int DIRECT_STEP = 5;
  private static final int MAJOR = 3;
  private static final int MINOR = 8;
  private static final List<String> SYSTEM = List.of(
      "173 x_ipc_newModuleConnectMsg", "168 x_ipc_registerMessageMsg", "166 x_ipc_registerHandlerMsg",
      "195 x_ipc_limitPendingMsg", "199 x_ipc_registerResourceMsg", "151 x_ipc_directResMsg",
      "147 x_ipc_directMsgQuery", "119 V_get_X_IPC_BROADCAST_MSG_VAR", "153 x_ipc_CloseMsg");
  private static final Map<String, IpcForm> SAID = forms(SystemMessages.CONNECT, SystemMessages.REGISTER_MESSAGE,
      SystemMessages.REGISTER_HANDLER, SystemMessages.LIMIT, SystemMessages.RESOURCE, SystemMessages.DIRECT,
      SystemMessages.ASK_DIRECT, SystemMessages.HANDLED, SystemMessages.CLOSE);
  private static final Map<String, IpcForm> ANSWERED = Map.of(SystemMessages.CONNECT.name(),
      SystemMessages.CONNECTED, SystemMessages.ASK_DIRECT.name(), SystemMessages.DIRECT_HANDLERS,
      SystemMessages.HANDLED.name(), SystemMessages.HANDLED_NAMES);

  private final boolean direct;
  private final Map<String, Entry> byName = new LinkedHashMap<>(); // guarded by this, as the following
  private final Map<Integer, Entry> byId = new HashMap<>();
  private final Map<Integer, Question> questions = new HashMap<>();
  private int references;

  /** A message and who handles it. */
  private record Entry(int id, String name, int kind, IpcFormat wire, IpcFormat content,
      Map<CentralClient, Integer> handlers) {}

  /** A question that is on its way to a module. */
  private record Question(CentralClient from, int reference) {}

  /**
   * Without modules.
   *
   * @param direct whether modules send messages to each other
   */
  public CentralBooks(boolean direct) {
    this.direct = direct;
    for (String each : SYSTEM) {
      String name = each.substring(each.indexOf(' ') + 1);
      IpcFormat answer =
          ANSWERED.containsKey(name) ? ANSWERED.get(name).format() : new IpcFormat.Nothing();
      add(new Entry(Integer.parseInt(each.substring(0, each.indexOf(' '))), name,
          ANSWERED.containsKey(name) ? IpcFrame.QUERY : IpcFrame.INFORM, SAID.get(name).format(), answer, Map.of()));
    }
  }

  private static Map<String, IpcForm> forms(IpcForm... forms) {
    return List.of(forms).stream().collect(Collectors.toMap(IpcForm::name, f -> f));
  }

  private void add(Entry entry) {
    byName.put(entry.name(), entry);
    byId.put(entry.id(), entry);
  }

  /** Who handles what, by names of messages and modules. */
  public synchronized Map<String, Set<String>> handlers() {
    Map<String, Set<String>> handlers = new TreeMap<>();
    byName.values().stream().filter(e -> !e.handlers().isEmpty()).forEach(e -> handlers.put(e.name(),
        e.handlers().keySet().stream().map(CentralClient::name).collect(Collectors.toSet())));
    return handlers;
  }

  /** A module has said something. */
  public synchronized void take(CentralClient from, IpcFrame frame) throws IOException {
    switch (frame.kind()) {
      case IpcFrame.COMPLETION -> from.completed(frame.dispatch());
      case IpcFrame.REPLY -> reply(from, frame);
      default -> route(from, frame);
    }
  }

  private void route(CentralClient from, IpcFrame frame) throws IOException {
    if (frame.intent() == INFO_ID) {
      answer(from, frame, info(SystemMessages.ASK_INFO.readBare(frame.body()).text("name")));
      return;
    }
    Entry entry = byId.get(frame.intent());
    if (entry == null) {
      throw new IpcFormatException(from.name() + " sends a message of the number " + frame.intent()
          + ", which was given to none");
    }
    if (SAID.containsKey(entry.name())) {
      system(from, frame, entry.name());
    } else if (frame.kind() == IpcFrame.QUERY) {
      question(from, frame, entry);
    } else {
      entry.handlers().forEach((to, handler) -> to.deliver(entry.name(), handler, frame.kind(), next(), frame));
    }
  }

  private int next() {
    references = references == Integer.MAX_VALUE ? 1 : references + 1;
    return references;
  }

  private void question(CentralClient from, IpcFrame frame, Entry entry) {
    entry.handlers().entrySet().stream().findFirst().ifPresent(handler -> {
      int reference = next();
      if (questions.size() < MOST_MESSAGES) {
        questions.put(reference, new Question(from, frame.reference()));
      }
      handler.getKey().deliver(entry.name(), handler.getValue(), IpcFrame.QUERY, reference, frame);
    });
  }

  private void reply(CentralClient from, IpcFrame frame) {
    Question question = questions.remove(frame.dispatch());
    if (question != null) {
      question.from().link().send(new IpcFrame(0, IpcFrame.REPLY_INTENT, IpcFrame.REPLY, 0, question.reference(),
          frame.name(), frame.order(), frame.body()));
    }
    from.completed(frame.dispatch());
  }

  private void system(CentralClient from, IpcFrame frame, String name) throws IOException {
    IpcRecord said = SAID.get(name).readBare(frame.body());
    switch (name) {
      case "x_ipc_newModuleConnectMsg" -> {
        from.introduce(said.text("module"), said.text("host"));
        answer(from, frame, SystemMessages.CONNECTED.writeBare(SystemMessages.CONNECTED.make()
            .struct("version", MAJOR, MINOR).number("direct", direct ? 1 : 0).build(), ByteOrder.LITTLE_ENDIAN));
      }
      case "x_ipc_registerMessageMsg" -> register(said);
      case "x_ipc_registerHandlerMsg" -> handler(from, said);
      case "x_ipc_limitPendingMsg" -> from.limit(said.text("message"), said.whole("limit"));
      case "x_ipc_directResMsg" -> from.listens(said.whole("port"));
      case "x_ipc_directMsgQuery" -> answer(from, frame, direct(said.text("message")));
      case "V_get_X_IPC_BROADCAST_MSG_VAR" -> answer(from, frame, handled());
      default -> {} // what a module takes at once, and that it goes, is not acted on
    }
  }

  private void register(IpcRecord said) throws IOException {
    IpcFormat content = FormatText.parse(said.text("content"));
    Entry known = byName.get(said.text("name"));
    if (known != null && known.content().equals(content) || known != null && SAID.containsKey(known.name())) {
      return;
    }
    if (byName.size() >= MOST_MESSAGES) {
      throw new IpcFormatException("there are " + MOST_MESSAGES + " messages already");
    }
    int number = known != null ? known.id()
        : direct ? -DIRECT_STEP * (byName.size() + 1) - 1 : FIRST_ID + byName.size();
    add(new Entry(number, said.text("name"), said.whole("kind"), FormatText.parse(said.text("wire")), content,
        known != null ? known.handlers() : new LinkedHashMap<>()));
  }

  /** With the number 0 a module handles a message no more. */
  private void handler(CentralClient from, IpcRecord said) throws IOException {
    Entry entry = byName.get(said.text("message"));
    if (entry == null || SAID.containsKey(entry.name())) {
      throw new IpcFormatException(from.name() + " handles " + said.text("message") + ", which was not registered");
    }
    if (said.whole("id") == 0) {
      entry.handlers().remove(from);
    } else {
      entry.handlers().put(from, said.whole("id"));
    }
  }

  private byte[] info(String name) {
    Entry entry = byName.get(name);
    if (entry == null) {
      return new byte[1];
    }
    IpcRecord info = new IpcRecord(SystemMessages.INFO.fields().getFirst().members(),
        List.of(new IpcValue.Whole(entry.id()), new IpcValue.Text(name), new IpcValue.Whole(entry.kind()),
            new IpcValue.Form(entry.wire()), new IpcValue.Form(entry.content())));
    return SystemMessages.INFO.writeBare(
        new IpcRecord(SystemMessages.INFO.fields(), List.of(new IpcValue.Members(info))), ByteOrder.LITTLE_ENDIAN);
  }

  private byte[] handled() {
    List<String> names =
        byName.values().stream().filter(e -> !e.handlers().isEmpty()).map(Entry::name).toList();
    return SystemMessages.HANDLED_NAMES.writeBare(
        SystemMessages.HANDLED_NAMES.make().number("used", names.size()).texts("names", names).build(),
        ByteOrder.LITTLE_ENDIAN);
  }

  /** Nothing at all where nobody handles it directly. */
  private byte[] direct(String message) {
    Entry entry = byName.get(message);
    List<IpcValue> handlers = new ArrayList<>();
    if (entry != null) {
      entry.handlers().forEach((client, number) -> {
        if (client.port() > 0) {
          handlers.add(new IpcValue.Members(new IpcRecord(
              SystemMessages.DIRECT_HANDLERS.fields().getLast().members(),
              List.of(new IpcValue.Whole(number), new IpcValue.Whole(0), new IpcValue.Whole(0),
                  new IpcValue.Whole(client.port()), new IpcValue.Text(client.host()),
                  new IpcValue.Text(client.name())))));
        }
      });
    }
    return handlers.isEmpty() ? new byte[0]
        : SystemMessages.DIRECT_HANDLERS.writeBare(new IpcRecord(SystemMessages.DIRECT_HANDLERS.fields(),
            List.of(new IpcValue.Whole(handlers.size()), new IpcValue.Items(handlers))), ByteOrder.LITTLE_ENDIAN);
  }

  private static void answer(CentralClient to, IpcFrame question, byte[] body) {
    to.link().send(new IpcFrame(0, IpcFrame.REPLY_INTENT, IpcFrame.SYSTEM, 0, question.reference(), "",
        ByteOrder.LITTLE_ENDIAN, ByteBuffer.wrap(body)));
  }

  /** A module has gone: it handles nothing any more, and asks nothing. */
  public synchronized void gone(CentralClient client) {
    byName.values().stream().filter(e -> !SAID.containsKey(e.name())).forEach(e -> e.handlers().remove(client));
    questions.values().removeIf(question -> question.from().equals(client));
  }
}
