package org.robotui.yarp.name;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.net.SocketFactory;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.yarp.bottle.YarpFormatException;
import org.robotui.yarp.internal.Dialing;
import org.robotui.yarp.internal.TextLines;

/**
 * Asks a name server, each time by a connection of its own. All that it does blocks for at most twice its patience, and
 * throws an {@link IOException} that names the server where that does not answer, or is none.
 *
 * @param server where it listens
 * @param sockets makes the connections
 * @param patience how long connecting, and then answering, may take
 */
public record NameClient(HostPort server, SocketFactory sockets, Duration patience) {
  private static final String LAST = "*** end of message";
  private static final int MOST_LINES = 1 << 14;
  private static final int BUFFER = 1 << 13;

  /**
   * All ports that it knows.
   *
   * @return in its order
   * @throws IOException where it does not answer
   */
  public List<YarpAddress> list() throws IOException {
    return addresses(ask("list"));
  }

  /**
   * Where a port listens.
   *
   * @param name of the port
   * @return empty where it is not registered
   * @throws IOException where the name server does not answer
   */
  public Optional<YarpAddress> query(String name) throws IOException {
    return addresses(ask("query " + checked(name))).stream().findFirst();
  }

  /**
   * Registers a port, in place of one of that name. Others are told what carriers it takes.
   *
   * @param name of the port
   * @param where it listens
   * @param accepts names of carriers
   * @throws IOException where the name server does not answer, or refuses
   */
  public void register(String name, HostPort where, Set<String> accepts) throws IOException {
    List<String> answer = ask("register " + checked(name) + " tcp " + where.host() + " " + where.port());
    if (addresses(answer).isEmpty()) {
      throw new IOException(server + " did not register " + name + ": " + PeerText.brief(String.join(" ", answer)));
    }
    ask("set " + name + " accepts " + String.join(" ", accepts));
    ask("announce " + name);
  }

  /**
   * Registers a group for datagrams that several ports shall receive, which the name server chooses.
   *
   * @return under which name, and where; to be unregistered
   * @throws IOException where the name server does not answer, or gives none
   */
  public YarpAddress group() throws IOException {
    List<String> answer = ask("register ... mcast ... 0");
    return addresses(answer).stream().findFirst().orElseThrow(() -> new IOException(
        server + " gave no group for datagrams: " + PeerText.brief(String.join(" ", answer))));
  }

  /**
   * Forgets a port.
   *
   * @param name of the port, which need not be registered
   * @throws IOException where the name server does not answer
   */
  public void unregister(String name) throws IOException {
    ask("unregister " + checked(name));
  }

  /**
   * What is known of a port.
   *
   * @param name of the port
   * @param property such as {@code accepts}
   * @return the words of the property
   * @throws IOException where the name server does not answer
   */
  public List<String> get(String name, String property) throws IOException {
    String answer = String.join(" ", ask("get " + checked(name) + " " + property));
    int equals = answer.indexOf(" = ");
    return equals < 0 ? List.of() : List.of(answer.substring(equals + 3).strip().split(" +"));
  }

  /**
   * By which address of this machine the server is reached: there its ports reach ours, where they run beside it.
   *
   * @return the address
   * @throws IOException where it is not reached
   */
  public InetAddress near() throws IOException {
    try (Socket socket = Dialing.connect(sockets, server, patience)) {
      return socket.getLocalAddress();
    }
  }

  private static String checked(String name) {
    if (!name.startsWith("/") || name.chars().anyMatch(c -> c <= ' ')) {
      throw new IllegalArgumentException("'" + name + "' is no name of a port; they begin with / and have no spaces");
    }
    return name;
  }

  private static List<YarpAddress> addresses(List<String> lines) {
    return lines.stream().flatMap(line -> YarpAddress.parse(line).stream()).toList();
  }

  private List<String> ask(String command) throws IOException {
    Socket socket = Dialing.connect(sockets, server, patience);
    try {
      DeadlineInput in = new DeadlineInput(socket, BUFFER);
      in.within(patience);
      socket.getOutputStream().write(TextLines.bytes("NAME_SERVER " + command + "\n"));
      return lines(in);
    } catch (EOFException | YarpFormatException e) {
      throw new IOException(server + " is no name server of YARP: " + e.getMessage(), e);
    } catch (IOException e) {
      throw new IOException("the name server at " + server + ": " + e.getMessage(), e);
    } finally {
      Sockets.closeQuietly(socket);
    }
  }

  private static List<String> lines(DeadlineInput in) throws IOException {
    List<String> lines = new ArrayList<>();
    while (lines.size() < MOST_LINES) {
      String line = TextLines.read(in);
      if (line.equals(LAST) || line.equals("[ok]")) {
        return lines;
      }
      lines.add(line);
    }
    throw new YarpFormatException("an answer of more than " + MOST_LINES + " lines");
  }
}
