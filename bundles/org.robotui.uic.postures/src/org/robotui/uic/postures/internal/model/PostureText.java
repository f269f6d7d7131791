package org.robotui.uic.postures.internal.model;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.input.Numerals;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;

/**
 * Postures as a file has them: YAML, as in a configuration. It is read by its nodes: no tag constructs anything, and
 * each fault has its line. Any thread.
 */
public final class PostureText {
  /** The most characters that are read. */
  public static final int MOST = 1 << 20;

  private static final int MAX_DEPTH = 10;
  private static final int MOST_JOINTS = 500;
  private static final Set<String> KEYS =
      Set.of(PostureSequence.NAME, PostureSequence.SECONDS, PostureSequence.JOINTS);

  private PostureText() {}

  /** What a file holds, or why it cannot be taken. */
  public sealed interface Content {
    /**
     * It can.
     *
     * @param sequence its postures
     */
    record Postures(PostureSequence sequence) implements Content {}

    /**
     * It cannot.
     *
     * @param why names the line and what to write
     */
    record Unreadable(String why) implements Content {}
  }

  /** What is wrong, with the line. */
  private static final class Fault extends Exception {
    private static final long serialVersionUID = 1;

    Fault(int line, String what) {
      super("line " + line + ": " + what);
    }
  }

  /** Reads a text. */
  public static Content read(String text) {
    try {
      Node root = new Yaml(limits()).compose(new StringReader(text));
      if (root == null) {
        return new Content.Unreadable("it is empty: a list `postures` is expected");
      }
      return new Content.Postures(sequence(root));
    } catch (Fault e) {
      return new Content.Unreadable(e.getMessage());
    } catch (MarkedYAMLException e) {
      int line = Optional.ofNullable(e.getProblemMark()).map(mark -> mark.getLine() + 1).orElse(1);
      return new Content.Unreadable("line " + line + ": this is no YAML: " + e.getProblem());
    } catch (YAMLException e) {
      return new Content.Unreadable("this is no YAML: " + e.getMessage());
    }
  }

  /** Writes postures for a file. */
  public static String write(PostureSequence sequence) {
    StringBuilder text = new StringBuilder(PostureSequence.POSTURES);
    text.append(sequence.postures().isEmpty() ? ": []\n" : ":\n");
    for (Posture posture : sequence.postures()) {
      text.append("  - name: ").append(quoted(posture.name())).append("\n    seconds: ").append(posture.seconds())
          .append("\n    joints: {");
      Map<?, ?> joints = (Map<?, ?>) posture.fields().get(PostureSequence.JOINTS);
      text.append(joints.entrySet().stream().map(joint -> quoted(joint.getKey().toString()) + ": " + joint.getValue())
          .collect(Collectors.joining(", "))).append("}\n");
    }
    return text.toString();
  }

  private static String quoted(String words) {
    String plain = words.codePoints().filter(c -> !Character.isISOControl(c))
        .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append).toString();
    return '"' + plain.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }

  private static LoaderOptions limits() {
    LoaderOptions options = new LoaderOptions();
    options.setNestingDepthLimit(MAX_DEPTH);
    options.setCodePointLimit(MOST);
    options.setAllowRecursiveKeys(false);
    return options;
  }

  private static PostureSequence sequence(Node root) throws Fault {
    List<Posture> postures = List.of();
    for (NodeTuple entry : section(root, "a list `postures`").getValue()) {
      String name = scalar(entry.getKeyNode(), "a name");
      if (!name.equals(PostureSequence.POSTURES)) {
        throw new Fault(line(entry.getKeyNode()), "'" + name + "' is not known here: write `postures`");
      }
      postures = postures(entry.getValueNode());
    }
    return new PostureSequence(postures);
  }

  private static List<Posture> postures(Node node) throws Fault {
    if (!(node instanceof SequenceNode list)) {
      throw new Fault(line(node),
          "a list of postures is expected, each as - {name: up, seconds: 3, joints: {elbow: 1}}");
    }
    if (list.getValue().size() > PostureSequence.MOST) {
      throw new Fault(line(node), "there are more than " + PostureSequence.MOST + " postures");
    }
    List<Posture> postures = new ArrayList<>();
    for (Node item : list.getValue()) {
      postures.add(posture(item));
    }
    return postures;
  }

  private static Posture posture(Node item) throws Fault {
    Map<String, Node> fields = new LinkedHashMap<>();
    for (NodeTuple entry : section(item, "a posture as {name: up, seconds: 3, joints: {elbow: 1}}").getValue()) {
      String key = scalar(entry.getKeyNode(), "a name");
      if (!KEYS.contains(key)) {
        throw new Fault(line(entry.getKeyNode()),
            "'" + key + "' is no part of a posture: name, seconds and joints are");
      }
      fields.put(key, entry.getValueNode());
    }
    if (!fields.keySet().containsAll(List.of(PostureSequence.NAME, PostureSequence.JOINTS))) {
      throw new Fault(line(item), "a posture needs `name` and `joints`");
    }
    String name = scalar(fields.get(PostureSequence.NAME), "a name").strip();
    Node seconds = fields.get(PostureSequence.SECONDS);
    double time = seconds == null ? 3 : number(seconds, Posture.SHORTEST, Posture.LONGEST);
    return new Posture(name, time, joints(fields.get(PostureSequence.JOINTS)));
  }

  private static Map<String, Double> joints(Node node) throws Fault {
    Map<String, Double> joints = new LinkedHashMap<>();
    for (NodeTuple entry : section(node, "positions by joint, as {elbow: 1.2}").getValue()) {
      String joint = scalar(entry.getKeyNode(), "a joint");
      joints.put(joint, number(entry.getValueNode(), -PostureSequence.FARTHEST, PostureSequence.FARTHEST));
    }
    if (joints.isEmpty() || joints.size() > MOST_JOINTS) {
      throw new Fault(line(node), "a posture has from 1 to " + MOST_JOINTS + " joints");
    }
    return joints;
  }

  private static double number(Node node, double least, double most) throws Fault {
    String written = scalar(node, "a number");
    Optional<Double> number = Numerals.decimal(written).filter(n -> n >= least && n <= most);
    if (number.isEmpty()) {
      throw new Fault(line(node), "'" + written.substring(0, Math.min(40, written.length()))
          + "' is no number from " + Numerals.text(least) + " to " + Numerals.text(most));
    }
    return number.get();
  }

  private static MappingNode section(Node node, String what) throws Fault {
    if (node instanceof MappingNode section) {
      return section;
    }
    throw new Fault(line(node), what + " is expected here");
  }

  private static String scalar(Node node, String what) throws Fault {
    if (node instanceof ScalarNode scalar) {
      return scalar.getValue();
    }
    throw new Fault(line(node), what + " is expected here");
  }

  private static int line(Node node) {
    return node.getStartMark().getLine() + 1;
  }
}
