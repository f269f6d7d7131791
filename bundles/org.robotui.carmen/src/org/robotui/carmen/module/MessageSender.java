package org.robotui.carmen.module;

import java.io.IOException;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.List;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.wire.IpcFrame;
import org.robotui.net.call.Outcome;
import org.robotui.net.link.FrameLink;

/** Sends the messages of one name: through the central, or to those who handle it. Safe for all threads. */
public final class MessageSender {

  private final IpcModule module;
  private final DirectLinks direct;
  private final KnownMessage known;
  private volatile List<DirectLinks.Handler> handlers = List.of();

  MessageSender(IpcModule module, DirectLinks direct, KnownMessage known) {
    this.module = module;
    this.direct = direct;
    this.known = known;
  }

  /**
   * What is sent.
   *
   * @return its form
   */
  public IpcForm form() {
    return known.form();
  }

  /**
   * Looks again who handles it, where modules are linked directly: they may have come or gone. This blocks.
   *
   * @throws IOException where the central does not answer, or a module is not reached
   */
  public void refresh() throws IOException {
    if (module.isDirect()) {
      handlers = direct.handlers(known.form().name());
    }
  }

  /**
   * Sends a message; never blocks.
   *
   * @param record its fields
   * @return false where the link has ended, or too much waits
   */
  public boolean publish(IpcRecord record) {
    byte[] body = known.form().write(record, ByteOrder.LITTLE_ENDIAN);
    List<DirectLinks.Handler> to = handlers;
    boolean sent = true;
    for (DirectLinks.Handler each : to) {
      sent &= each.link().send(frame(each.number(), IpcFrame.BROADCAST, module.pending().next(), body));
    }
    return to.isEmpty()
        ? module.link().send(frame(known.id(), IpcFrame.BROADCAST, module.pending().next(), body))
        : sent;
  }

  /**
   * Sends a command, in place of an older one that still waits; never blocks.
   *
   * @param record its fields
   * @return false where the link has ended
   */
  public boolean command(IpcRecord record) {
    byte[] body = known.form().write(record, ByteOrder.LITTLE_ENDIAN);
    String kind = known.form().name();
    List<DirectLinks.Handler> to = handlers;
    boolean sent = true;
    for (DirectLinks.Handler each : to) {
      sent &= each.link().replace(kind, frame(each.number(), IpcFrame.BROADCAST, module.pending().next(), body));
    }
    return to.isEmpty()
        ? module.link().replace(kind, frame(known.id(), IpcFrame.BROADCAST, module.pending().next(), body))
        : sent;
  }

  /**
   * Asks a question of it, which blocks.
   *
   * @param record its fields
   * @param patience how long the answer may take
   * @return the answer, or why there is none; IPC tells nothing where nobody answers
   */
  public Outcome<IpcAnswer> query(IpcRecord record, Duration patience) {
    byte[] body = known.form().write(record, ByteOrder.LITTLE_ENDIAN);
    List<DirectLinks.Handler> to = handlers;
    FrameLink<IpcFrame> link = to.isEmpty() ? module.link() : to.getFirst().link();
    int intent = to.isEmpty() ? known.id() : to.getFirst().number();
    try {
      IpcFrame answer = module.pending().ask(known.form().name(), patience,
          reference -> link.send(frame(intent, IpcFrame.QUERY, reference, body)));
      IpcForm form = form(answer.name());
      return new Outcome.Done<>(new IpcAnswer(form, form.read(answer.body())));
    } catch (IOException e) {
      return new Outcome.Failed<>(e.getMessage());
    }
  }

  private IpcForm form(String name) throws IOException {
    return module.look(name).map(KnownMessage::form).or(() -> module.forms().named(name))
        .orElseThrow(() -> new IOException("the answer is a " + name + ", of which nothing is known"));
  }

  private static IpcFrame frame(int intent, int kind, int reference, byte[] body) {
    return IpcFrame.of(intent, kind, reference, body);
  }
}
