package org.robotui.yarp.port;

import java.io.IOException;
import java.net.Socket;
import java.util.List;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleText;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.internal.Dialing;
import org.robotui.yarp.internal.TextLines;
import org.robotui.yarp.wire.YarpCarrier;

/**
 * Tells ports of others whom they shall say their messages to, as {@code yarp connect} does. Each command has a
 * connection of its own, by the carrier text_ack, and blocks for at most twice the patience of the options.
 *
 * @param options of connections
 */
public record PortAdmin(PortOptions options) {
  private static final String ACKNOWLEDGED = "<ACK>";
  private static final int BUFFER = 1 << 12;
  private static final int MOST_LINES = 1 << 12;

  /**
   * Lets a port say its messages to another one, which it looks up by its name.
   *
   * @param port where it listens
   * @param carrier by which
   * @param target the name of the other port
   * @return what the port says of it
   */
  public Outcome<String> connect(HostPort port, YarpCarrier carrier, String target) {
    return done(admin(port, new Bottle(List.of(YarpValue.Vocab.of("add"),
        new YarpValue.Text(carrier.word() + ":/" + target)), 0)));
  }

  /**
   * Lets a port say its messages to another one no more.
   *
   * @param port where it listens
   * @param target the name of the other port
   * @return what the port says of it
   */
  public Outcome<String> disconnect(HostPort port, String target) {
    return done(admin(port, new Bottle(List.of(YarpValue.Vocab.of("del"), new YarpValue.Text(target)), 0)));
  }

  /**
   * To whom a port says its messages.
   *
   * @param port where it listens
   * @return names of ports
   */
  public Outcome<List<String>> targets(HostPort port) {
    return admin(port, Bottle.of(Bottle.vocabs("list", "out")))
        .map(answer -> answer.values().stream().map(YarpValue::text).toList());
  }

  /**
   * Whether a port answers, as {@code yarp ping} asks.
   *
   * @param port where it listens
   * @return what it says of itself
   */
  public Outcome<String> ping(HostPort port) {
    return ask(port, "*" + TextLines.END);
  }

  private Outcome<Bottle> admin(HostPort port, Bottle command) {
    Outcome<String> answer = ask(port, "a" + TextLines.END + BottleText.format(command) + TextLines.END);
    try {
      return answer instanceof Outcome.Done<String> done ? new Outcome.Done<>(BottleText.parse(done.value()))
          : answer.map(text -> Bottle.of());
    } catch (IOException e) {
      return new Outcome.Failed<>(port + " answered what is none of YARP's: " + e.getMessage());
    }
  }

  /** Its answers begin with a number, which is 0 where all is well. */
  private static Outcome<String> done(Outcome<Bottle> answer) {
    return answer instanceof Outcome.Done<Bottle> done && done.value().get(0).number() != 0
        ? new Outcome.Refused<>(PeerText.brief(done.value().get(1).text().strip()))
        : answer.map(bottle -> PeerText.brief(bottle.get(1).text().strip()));
  }

  private Outcome<String> ask(HostPort port, String lines) {
    try (Socket socket = Dialing.connect(options.sockets(), port, options.patience())) {
      DeadlineInput in = new DeadlineInput(socket, BUFFER);
      in.within(options.patience());
      socket.getOutputStream().write(TextLines.bytes("CONNACK admin" + TextLines.END));
      if (!TextLines.read(in).startsWith("Welcome")) {
        return new Outcome.Failed<>(port + " is no port of YARP");
      }
      socket.getOutputStream().write(TextLines.bytes(lines));
      String answer = answer(in);
      Sockets.closeQuietly(socket);
      return new Outcome.Done<>(answer);
    } catch (IOException e) {
      return new Outcome.Failed<>(port + ": " + PeerText.brief(String.valueOf(e.getMessage())));
    }
  }

  private static String answer(DeadlineInput in) throws IOException {
    StringBuilder answer = new StringBuilder();
    String line = TextLines.read(in);
    for (int i = 0; !line.equals(ACKNOWLEDGED) && i < MOST_LINES; i++) {
      answer.append(answer.isEmpty() ? "" : "\n").append(line);
      line = TextLines.read(in);
    }
    return answer.toString();
  }
}
