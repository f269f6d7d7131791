package org.robotui.carmen.module;

import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.carmen.format.IpcFormatException;
import org.robotui.carmen.internal.IpcLinks;
import org.robotui.carmen.internal.SystemMessages;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcRecordMaker;
import org.robotui.carmen.message.IpcValue;
import org.robotui.carmen.wire.IpcFrame;
import org.robotui.net.call.OpenQuestions;
import org.robotui.net.link.FrameLink;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.net.thread.Workers;

/** A module that is linked to a central. Safe for all threads. */
public final class IpcModule implements AutoCloseable {

  private static final Duration END = Duration.ofMillis(1000);
  private static final int CAPACITY = 4;
  private static final int DEFAULT_LIMIT = 100;

  private final HostPort central;
  private final ModuleOptions options;
  private final IpcForms forms;
  private final String name;
  private final Workers workers;
  private final FrameLink<IpcFrame> link;
  private final int infoId;
  private final OpenQuestions<IpcFrame> pending = new OpenQuestions<>();
  private final Map<String, KnownMessage> system = new ConcurrentHashMap<>();
  private final HandlerTable subscriptions;
  private final DirectLinks direct;
  private final AtomicReference<Optional<String>> over = new AtomicReference<>(Optional.empty());

  private IpcModule(HostPort central, IpcForms forms, ModuleOptions options, Socket socket) throws IOException {
    this.central = central;
    this.options = options;
    this.forms = forms;
    this.name = options.name() + "-" + socket.getLocalPort();
    this.workers = new Workers(options.threads());
    this.subscriptions = new HandlerTable();
    this.link = IpcLinks.of(socket, new FromCentral());
    link.input().within(options.patience());
    this.infoId = ByteBuffer.wrap(greeting()).getInt();
    this.direct = new DirectLinks(this, workers, options, socket.getLocalAddress());
  }

  /** Before the first frame a central says the number of the question for what it knows. */
  private byte[] greeting() throws IOException {
    byte[] number = link.input().readNBytes(Integer.BYTES);
    if (number.length < Integer.BYTES) {
      throw new IOException(central + " ended the connection without a word; it is no central of IPC");
    }
    if (number[0] != 0) {
      throw new IpcFormatException(central + " begins as no central of IPC does");
    }
    return number;
  }

  /**
   * Links a module to a central, which blocks.
   *
   * @param central where it listens
   * @param forms the messages whose fields have names
   * @param options how to be linked
   * @return linked
   * @throws IOException where the central is not reached, or is none; says why
   */
  public static IpcModule connect(HostPort central, IpcForms forms, ModuleOptions options) throws IOException {
    Socket socket = options.sockets().createSocket();
    try {
      Sockets.minimizeSendBuffer(socket);
      central.connect(socket, options.patience());
      Sockets.prepare(socket);
      IpcModule module = new IpcModule(central, forms, options, socket);
      try {
        module.introduce(socket.getLocalAddress().getHostAddress());
        return module;
      } catch (IOException | RuntimeException e) {
        module.close();
        throw e;
      }
    } catch (IOException | RuntimeException e) {
      Sockets.closeQuietly(socket);
      throw e;
    }
  }

  private void introduce(String address) throws IOException {
    link.start(workers, "carmen central " + central);
    IpcRecord hello = SystemMessages.CONNECT.make().text("module", name).text("host", address).build();
    IpcFrame answer = askSystem(SystemMessages.CONNECT, hello);
    if (SystemMessages.CONNECTED.readBare(answer.body()).whole("direct") != 0) {
      tell(SystemMessages.DIRECT, SystemMessages.DIRECT.make().number("port", direct.listen()).text("module", name));
    }
    system(SystemMessages.CLOSE);
    tell(SystemMessages.RESOURCE, SystemMessages.RESOURCE.make().number("capacity", CAPACITY).text("module", name));
  }

  /**
   * How the central knows it.
   *
   * @return its name with a number
   */
  public String name() {
    return name;
  }

  /**
   * Whether modules send messages to each other without the central.
   *
   * @return as the central says
   */
  public boolean isDirect() {
    return direct.listens();
  }

  /**
   * Why the link has ended.
   *
   * @return empty while it is there
   */
  public Optional<String> over() {
    return over.get();
  }

  /**
   * Looks a message up, which blocks.
   *
   * @param message its name
   * @return empty where the central does not know it
   * @throws IOException where it does not answer, or what it says cannot be read
   */
  public Optional<KnownMessage> look(String message) throws IOException {
    IpcRecord question = SystemMessages.ASK_INFO.make().text("name", message).build();
    IpcFrame answer = ask("what " + central + " knows of " + message, infoId, SystemMessages.ASK_INFO, question);
    if (!(SystemMessages.INFO.readBare(answer.body()).values().getFirst() instanceof IpcValue.Members info)) {
      return Optional.empty();
    }
    IpcRecord known = info.record();
    boolean plain = known.whole("kind") == IpcFrame.BROADCAST;
    IpcValue format = known.field(plain ? "content" : "wire").orElseThrow();
    return Optional.of(new KnownMessage(known.whole("id"),
        forms.of(message, format instanceof IpcValue.Form f ? f.format() : SystemMessages.CLOSE.format()), plain));
  }

  /**
   * Which messages are handled by somebody, which blocks.
   *
   * @return their names
   * @throws IOException where the central does not answer
   */
  public List<String> handled() throws IOException {
    IpcFrame answer = askSystem(SystemMessages.HANDLED, IpcRecord.EMPTY);
    return SystemMessages.HANDLED_NAMES.readBare(answer.body()).texts("names").stream().filter(n -> !n.isEmpty())
        .toList();
  }

  /**
   * Who sends a message; it is registered, and where modules are linked directly, those that handle it are called. This
   * blocks.
   *
   * @param form of the message
   * @return what sends it
   * @throws IOException where the central does not answer
   */
  public MessageSender sender(IpcForm form) throws IOException {
    define(form);
    KnownMessage known = look(form.name())
        .orElseThrow(() -> new IOException(central + " did not take the message " + form.name()));
    MessageSender sender = new MessageSender(this, direct, known);
    sender.refresh();
    return sender;
  }

  private void define(IpcForm form) throws IOException {
    tell(SystemMessages.REGISTER_MESSAGE, SystemMessages.REGISTER_MESSAGE.make().text("name", form.name())
        .number("kind", IpcFrame.BROADCAST).text("wire", SystemMessages.WRAPPED).text("content", form.text()));
  }

  /**
   * Subscribes to a message, or offers to answer a question. This blocks.
   *
   * @param form of the message
   * @param limit how many may wait at the central; with 1 the latest
   * @param handling takes them
   * @return ends it, which does not block
   * @throws IOException where the central does not answer, or there are too many
   */
  public AutoCloseable subscribe(IpcForm form, int limit, Handling handling) throws IOException {
    define(form);
    KnownMessage known = look(form.name())
        .orElseThrow(() -> new IOException(central + " did not take the message " + form.name()));
    IpcForm read = forms.named(form.name()).isPresent() ? known.form() : form;
    int id = subscriptions.add(new HandlerTable.Entry(read, known.id() < 0, handling));
    handler(id, form.name(), limit);
    return () -> {
      if (subscriptions.remove(form.name(), handling) && over().isEmpty()) {
        handler(0, form.name(), DEFAULT_LIMIT);
      }
    };
  }

  private void handler(int id, String message, int limit) throws IOException {
    tell(SystemMessages.REGISTER_HANDLER, SystemMessages.REGISTER_HANDLER.make().number("id", id)
        .text("message", message).text("handler", "HND-" + message + System.identityHashCode(this)));
    tell(SystemMessages.LIMIT,
        SystemMessages.LIMIT.make().text("message", message).text("module", name).number("limit", limit));
  }

  /** The numbers of a central's own messages are looked up once. */
  private KnownMessage system(IpcForm form) throws IOException {
    KnownMessage known = system.get(form.name());
    if (known == null) {
      known = look(form.name()).orElseThrow(() -> new IOException(central + " has no " + form.name()));
      system.put(form.name(), known);
    }
    return known;
  }

  private void tell(IpcForm form, IpcRecordMaker message) throws IOException {
    byte[] body = form.writeBare(message.build(), ByteOrder.LITTLE_ENDIAN);
    if (!link.send(IpcFrame.of(system(form).id(), IpcFrame.INFORM, pending.next(), body))) {
      throw new IOException(central + " takes nothing more");
    }
  }

  IpcFrame askSystem(IpcForm form, IpcRecord record) throws IOException {
    return ask(form.name() + " of " + central, system(form).id(), form, record);
  }

  private IpcFrame ask(String what, int id, IpcForm form, IpcRecord record) throws IOException {
    byte[] body = form.writeBare(record, ByteOrder.LITTLE_ENDIAN);
    return pending.ask(what, options.patience(), ref -> link.send(IpcFrame.of(id, IpcFrame.QUERY, ref, body)));
  }

  HostPort central() {
    return central;
  }

  IpcForms forms() {
    return forms;
  }

  FrameLink<IpcFrame> link() {
    return link;
  }

  OpenQuestions<IpcFrame> pending() {
    return pending;
  }

  /** A message for a handler of ours, by whichever link. */
  void deliver(IpcFrame frame, FrameLink<IpcFrame> from) {
    Optional<HandlerTable.Entry> entry = subscriptions.handler(frame.intent());
    Optional<IpcAnswer> answer = entry.flatMap(each -> each.take(frame));
    boolean central = from.equals(link);
    boolean straight = !central || entry.isPresent() && entry.get().direct();
    int intent = straight ? IpcFrame.REPLY_INTENT : IpcFrame.TO_CENTRAL;
    int reference = straight ? frame.reference() : IpcFrame.NONE;
    if (answer.isPresent()) {
      byte[] body = answer.get().form().write(answer.get().record(), ByteOrder.LITTLE_ENDIAN);
      from.send(new IpcFrame(central ? frame.reference() : IpcFrame.NONE, intent, IpcFrame.REPLY, frame.reference(),
          reference, answer.get().form().name(), ByteOrder.LITTLE_ENDIAN, ByteBuffer.wrap(body)));
    } else if (central) {
      from.send(new IpcFrame(frame.reference(), intent, IpcFrame.COMPLETION, frame.reference(), reference, "",
          ByteOrder.LITTLE_ENDIAN, ByteBuffer.allocate(0)));
    }
  }

  private final class FromCentral implements FrameLink.Receiver<IpcFrame> {
    @Override
    public void received(IpcFrame frame, FrameLink<IpcFrame> from) {
      if (frame.intent() == IpcFrame.REPLY_INTENT) {
        pending.answered(frame.reference(), frame);
      } else if (frame.intent() > 0) {
        deliver(frame, from);
      }
    }

    @Override
    public void ended(FrameLink<IpcFrame> from, String reason) {
      over.compareAndSet(Optional.empty(), Optional.of(central + ": " + reason));
      pending.fail(reason);
    }
  }

  /** Says goodbye, where the central still takes it, and ends all links; bounded. */
  @Override
  public void close() {
    KnownMessage goodbye = system.get(SystemMessages.CLOSE.name());
    if (goodbye != null) {
      link.send(IpcFrame.of(goodbye.id(), IpcFrame.INFORM, pending.next(), new byte[0]));
    }
    direct.close();
    link.close();
    workers.join(System.nanoTime() + END.toNanos());
  }
}
