package org.robotui.smartsoft.client;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import org.robotui.message.MessageException;
import org.robotui.net.call.OpenQuestions;
import org.robotui.smartsoft.internal.PatternData;
import org.robotui.smartsoft.internal.PatternLink;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.wire.LinkOptions;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;

/** A client of query. Several threads may ask at once. */
public final class QueryClient implements PatternClient {

  private final OpenQuestions<ByteBuffer> questions = new OpenQuestions<>();
  private final PatternLink link;

  private QueryClient(ServiceAddress address, LinkOptions options) throws IOException {
    this.link = PatternLink.connect(address, options, new FromServer());
  }

  /**
   * Connects to a service; blocks.
   *
   * @param address of the service
   * @param options how to be linked
   * @return connected
   * @throws IOException where it is not reached, or does not take us
   */
  public static QueryClient connect(ServiceAddress address, LinkOptions options) throws IOException {
    return new QueryClient(address, options);
  }

  /**
   * Asks; blocks.
   *
   * @param request little endian
   * @param patience how long the answer may take
   * @return the answer, in the order of its bytes
   * @throws IOException where none comes, with the reason
   */
  public ByteBuffer query(ByteBuffer request, Duration patience) throws IOException {
    return questions.ask("the query", patience,
        number -> link.send(SmartFrame.of(SmartCommand.REQUEST, PatternData.of().i64(number).end(), request)));
  }

  private final class FromServer implements PatternLink.Listener {
    @Override
    public void said(SmartCommand command, SmartFrame frame) throws IOException {
      if (command == SmartCommand.ANSWER) {
        try {
          questions.answered((int) frame.reader().int64("query"), frame.object());
        } catch (MessageException e) {
          throw new IOException(e.getMessage(), e);
        }
      }
    }

    @Override
    public void ended(String reason) {
      questions.fail(reason);
    }
  }

  @Override
  public Optional<String> over() {
    return link.over();
  }

  @Override
  public void finish() {
    link.finish();
  }

  @Override
  public void close() {
    link.close();
  }
}
