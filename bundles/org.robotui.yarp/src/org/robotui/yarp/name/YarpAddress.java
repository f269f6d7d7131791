package org.robotui.yarp.name;

import java.util.Optional;
import org.robotui.net.socket.HostPort;

/**
 * Where a port listens.
 *
 * @param name of the port, such as {@code /laser}
 * @param where it listens
 * @param carrier that it takes first, {@code tcp} mostly
 */
public record YarpAddress(String name, HostPort where, String carrier) {
  private static final String FORM = "registration name ";
  private static final int WORDS = 9;
  private static final int HOST = 4;
  private static final int PORT = 6;

  /**
   * Reads a line of a name server.
   *
   * @param line such as {@code registration name /laser ip 127.0.0.1 port 10004 type tcp}
   * @return empty where it is another line
   */
  public static Optional<YarpAddress> parse(String line) {
    String[] words = line.strip().split(" +");
    if (!line.startsWith(FORM) || words.length < WORDS || !words[PORT].matches("\\d{1,5}")) {
      return Optional.empty();
    }
    try {
      return Optional.of(new YarpAddress(words[2], new HostPort(words[HOST], Integer.parseInt(words[PORT])),
          words[WORDS - 1]));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /**
   * As a name server writes it.
   *
   * @return a line without its end
   */
  public String line() {
    return FORM + name + " ip " + where.host() + " port " + where.port() + " type " + carrier;
  }
}
