package org.robotui.ros2.internal;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Environment.Range;
import org.robotui.ros2.name.RemapRule;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Interfaces;
import org.robotui.rtps.ParticipantSettings;
import org.robotui.rtps.InitialPeer;

/** Reads environment variables and command lines of ROS 2. */
public final class Ros2EnvironmentParser {

  private static final ByteBuffer ENCLAVE = StandardCharsets.UTF_8.encode("enclave=/;").asReadOnlyBuffer();

  private final List<RemapRule> rules = new ArrayList<>();
  private final List<String> rest = new ArrayList<>();

  private Ros2EnvironmentParser() {}

  /**
   * Reads them.
   *
   * @param variables the environment variables
   * @param arguments the command line
   * @return the environment
   */
  public static Ros2Environment parse(Map<String, String> variables, List<String> arguments) {
    Ros2EnvironmentParser parser = new Ros2EnvironmentParser();
    parser.arguments(arguments.iterator());
    return new Ros2Environment(domain(text(variables, "ROS_DOMAIN_ID")), range(variables),
        peers(text(variables, "ROS_STATIC_PEERS")), List.of(), Ros2Name.ROOT, parser.rules, parser.rest);
  }

  private void arguments(Iterator<String> words) {
    boolean ros = false;
    while (words.hasNext()) {
      String word = words.next();
      boolean remap = ros && (word.equals("-r") || word.equals("--remap"));
      if (word.equals("--ros-args") || word.equals("--")) {
        ros = word.equals("--ros-args");
      } else if (remap && words.hasNext()) {
        rules.add(RemapRule.parse(words.next()));
      } else {
        rest.add(word);
      }
    }
  }

  private static String text(Map<String, String> variables, String name) {
    return variables.getOrDefault(name, "").strip();
  }

  private static int domain(String text) {
    try {
      return text.isEmpty() ? 0 : Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("ROS_DOMAIN_ID: '" + text + "' is no number; write 0 to "
          + ParticipantSettings.MAX_DOMAIN, e);
    }
  }

  private static Range range(Map<String, String> variables) {
    if (text(variables, "ROS_LOCALHOST_ONLY").equals("1")) {
      return Range.LOCALHOST;
    }
    String text = text(variables, "ROS_AUTOMATIC_DISCOVERY_RANGE").toUpperCase(Locale.ROOT);
    return switch (text) {
      case "", "SYSTEM_DEFAULT", "LOCALHOST" -> Range.LOCALHOST;
      case "SUBNET" -> Range.SUBNET;
      case "OFF" -> Range.OFF;
      default -> throw new IllegalArgumentException("ROS_AUTOMATIC_DISCOVERY_RANGE: '" + text
          + "' is no range; write LOCALHOST, SUBNET or OFF");
    };
  }

  private static List<String> peers(String text) {
    return Arrays.stream(text.split(";")).map(String::strip).filter(peer -> !peer.isEmpty()).toList();
  }

  /**
   * What a participant is made with.
   *
   * @param environment what was read
   * @param name of the participant
   * @return the settings
   */
  public static ParticipantSettings settings(Ros2Environment environment, String name) {
    ParticipantSettings plain = ParticipantSettings.standard(environment.domain(), name).withUserData(ENCLAVE);
    List<InitialPeer> peers =
        environment.staticPeers().stream().map(host -> new InitialPeer(host, OptionalInt.empty())).toList();
    return switch (environment.range()) {
      case OFF -> plain.withPeers(false, List.of());
      case LOCALHOST -> peers.isEmpty() ? plain.withPeers(true, withLocal(peers))
          : plain.withInterfaces(new Interfaces.All()).withPeers(false, withLocal(peers));
      case SUBNET -> plain.withInterfaces(used(environment.interfaces())).withPeers(true, peers);
    };
  }

  /** Not every machine has multicast on loopback, and programs that look further do not use it there. */
  private static List<InitialPeer> withLocal(List<InitialPeer> peers) {
    return Stream.concat(Stream.of(new InitialPeer("127.0.0.1", OptionalInt.empty())), peers.stream()).toList();
  }

  private static Interfaces used(List<String> names) {
    return names.isEmpty() ? new Interfaces.All() : new Interfaces.Named(names);
  }
}
