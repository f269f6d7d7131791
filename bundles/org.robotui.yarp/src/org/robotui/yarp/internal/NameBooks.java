package org.robotui.yarp.internal;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadLocalRandom;
import org.robotui.net.socket.HostPort;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.name.YarpAddress;

/** What a name server knows, and what it answers. Safe for all threads. */
public final class NameBooks {
  private static final int MOST = 1 << 14;
  private static final int FIRST_PORT = 10_002;
  private static final String LAST = "*** end of message" + TextLines.END;
  private static final String MADE_UP = "...";
  private static final int REGISTER = 5;
  private static final int BYTE = 255;

  private final NavigableMap<String, YarpAddress> ports = new TreeMap<>(); // guarded by this
  private final Map<String, TreeSet<String>> properties = new ConcurrentHashMap<>();

  /** All ports. */
  public synchronized List<YarpAddress> all() {
    return List.copyOf(ports.values());
  }

  /** Registers a port. */
  public synchronized void put(YarpAddress address) {
    ports.put(address.name(), address);
  }

  /** The answer to a line, with its end. */
  public String answer(String line) {
    String[] words = line.strip().split("\\s+");
    String argument = words.length > 1 ? words[1] : "";
    return switch (words[0]) {
      case "announce" -> "[ok]" + TextLines.END;
      case "list" -> lines(all());
      case "query" -> lines(find(argument).stream().toList());
      case "register" -> lines(register(words).stream().toList());
      case "unregister" -> unregister(argument);
      case "set" -> set(words);
      case "get" -> words.length > 2 ? property(argument, words[2]) : LAST;
      case "help" -> "commands: announce, get, help, list, query, register, set, unregister" + TextLines.END + LAST;
      default -> "unknown command" + TextLines.END + LAST;
    };
  }

  private static String lines(Collection<YarpAddress> addresses) {
    StringBuilder lines = new StringBuilder();
    addresses.forEach(address -> lines.append(address.line()).append(TextLines.END));
    return lines.append(LAST).toString();
  }

  private synchronized Optional<YarpAddress> find(String name) {
    return Optional.ofNullable(ports.get(name));
  }

  /** {@code register NAME CARRIER HOST PORT}; dots, and the port 0, stand for what the server chooses. */
  private synchronized Optional<YarpAddress> register(String[] words) {
    if (words.length < 2 || ports.size() >= MOST) {
      return Optional.empty();
    }
    String name = words[1].equals(MADE_UP) ? "/tmp/port/" + ports.size() : words[1];
    boolean shared = words.length >= REGISTER && words[2].equals("mcast");
    String chosen = shared ? group() : "127.0.0.1";
    String host = words.length < REGISTER || words[3].equals(MADE_UP) ? chosen : words[3];
    String port = words.length < REGISTER || words[REGISTER - 1].matches("\\.\\.\\.|0") ? "" : words[REGISTER - 1];
    try {
      YarpAddress address =
          new YarpAddress(name, new HostPort(host, port.isEmpty() ? free() : Integer.parseInt(port)),
              shared ? "mcast" : "tcp");
      ports.put(name, address);
      return Optional.of(address);
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /** Two name servers in one network must not give out the same: any of a quarter of a million groups. */
  private static String group() {
    ThreadLocalRandom random = ThreadLocalRandom.current();
    return "224." + random.nextInt(1, 5) + "." + random.nextInt(1, BYTE) + "." + random.nextInt(1, BYTE);
  }

  private int free() {
    return ports.values().stream().mapToInt(p -> p.where().port() + 1).max().orElse(FIRST_PORT);
  }

  private synchronized String unregister(String name) {
    ports.remove(name);
    properties.keySet().removeIf(key -> key.startsWith(name + " "));
    return LAST;
  }

  private String set(String[] words) {
    if (words.length < 3 || properties.size() >= MOST) {
      return LAST;
    }
    properties.put(words[1] + " " + words[2], new TreeSet<>(List.of(words).subList(3, words.length)));
    return property(words[1], words[2]);
  }

  private String property(String name, String property) {
    return "port " + name + " property " + property + " = "
        + String.join(" ", properties.getOrDefault(name + " " + property, new TreeSet<>())) + TextLines.END + LAST;
  }

  /** The answer to a question by the carrier tcp, which is a bottle. */
  public Bottle answer(Bottle question) {
    return switch (question.get(1).text()) {
      case "query" -> find(question.get(2).text()).map(NameBooks::entry).orElse(Bottle.of());
      case "list" -> {
        List<Object> entries = new ArrayList<>(List.of("ports"));
        all().forEach(address -> entries.add(entry(address)));
        yield Bottle.of(entries.toArray());
      }
      default -> Bottle.of(Bottle.vocabs("fail"));
    };
  }

  private static Bottle entry(YarpAddress address) {
    return Bottle.of("port", List.of("name", address.name()), List.of("ip", address.where().host()),
        List.of("port_number", address.where().port()), List.of("carrier", address.carrier()));
  }
}
