package org.robotui.roblets.wire;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;

/**
 * What a roblet says and takes, as its beacons tell.
 *
 * @param name of the roblet, one of its kind in a body
 * @param frequency how often it runs, Hz
 * @param outputs what it says
 * @param inputs what it takes
 * @param friends roblets to which it speaks without the brain
 */
public record RobletForm(String name, double frequency, List<BodyForm> outputs, List<BodyForm> inputs,
    List<String> friends) {
  private static final int MOST = 64;

  /**
   * Copies the lists.
   *
   * @param name of the roblet
   * @param frequency Hz, more than 0 and 1000 at most
   * @param outputs what it says
   * @param inputs what it takes
   * @param friends to whom it speaks
   * @throws IllegalArgumentException where name or frequency is none
   */
  public RobletForm {
    BodyElement.checked(name);
    if (!(frequency > 0 && frequency <= 1000)) {
      throw new IllegalArgumentException(name + " has a frequency of " + frequency + " Hz; write 0.001 to 1000");
    }
    outputs = bounded(outputs);
    inputs = bounded(inputs);
    friends = bounded(friends);
  }

  private static <T> List<T> bounded(List<T> all) {
    return List.copyOf(all.subList(0, Math.min(MOST, all.size())));
  }

  /**
   * What it says by that name.
   *
   * @param output its name
   * @return none where it says no such thing
   */
  public Optional<BodyForm> output(String output) {
    return outputs.stream().filter(form -> form.name().equals(output)).findFirst();
  }

  /**
   * What it takes by that name.
   *
   * @param input its name
   * @return none where it takes no such thing
   */
  public Optional<BodyForm> input(String input) {
    return inputs.stream().filter(form -> form.name().equals(input)).findFirst();
  }

  /**
   * Written into a beacon.
   *
   * @return an element {@code roblet}
   */
  public BodyElement element() {
    List<BodyElement> parts = new ArrayList<>();
    outputs.forEach(form -> parts.add(form.element("output")));
    inputs.forEach(form -> parts.add(form.element("input")));
    friends.forEach(friend -> parts.add(BodyElement.of("friend").with("name", friend)));
    return BodyElement.of("roblet").with("name", name).with("frequency", frequency).with(parts);
  }

  /**
   * Read from a beacon.
   *
   * @param element as it was written
   * @return the form
   * @throws IllegalArgumentException where a name is none
   */
  public static RobletForm of(BodyElement element) {
    return new RobletForm(element.attribute("name").orElse(""), element.number("frequency").orElse(1),
        forms(element, "output").map(BodyForm::of).toList(), forms(element, "input").map(BodyForm::of).toList(),
        forms(element, "friend").map(f -> BodyElement.checked(f.attribute("name").orElse(""))).toList());
  }

  private static Stream<BodyElement> forms(BodyElement element, String direction) {
    return element.children().stream().filter(c -> c.name().equals(direction));
  }
}
