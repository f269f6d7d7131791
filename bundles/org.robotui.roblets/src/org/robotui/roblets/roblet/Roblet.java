package org.robotui.roblets.roblet;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.RecordMessage;
import org.robotui.roblets.wire.RobletForm;

/**
 * An organ of a robot's body: it does something again and again, says how it is each time, and takes messages. All its
 * methods are called by one thread. What one of them throws ends it: it has failed, and another instance is started.
 */
public interface Roblet {
  /**
   * What it says and takes; by its annotations where it says nothing else.
   *
   * @return the form, always the same
   */
  default RobletForm form() {
    Class<?> type = getClass();
    RobletInfo info = Optional.ofNullable(type.getAnnotation(RobletInfo.class)).orElseThrow(
        () -> new IllegalArgumentException(type.getName() + " has neither @RobletInfo nor a form of its own"));
    String simple = type.getSimpleName().replaceFirst("Roblet$", "");
    String name =
        info.name().isEmpty() ? simple.substring(0, 1).toLowerCase(Locale.ROOT) + simple.substring(1) : info.name();
    return new RobletForm(name, info.frequency(),
        Arrays.stream(type.getAnnotationsByType(OutputMessage.class)).map(o -> RecordMessage.of(o.value()).form())
            .toList(),
        Arrays.stream(type.getAnnotationsByType(InputMessage.class)).map(i -> RecordMessage.of(i.value()).form())
            .toList(),
        List.of(info.friends()));
  }

  /**
   * Begins.
   *
   * @param speech says messages
   * @throws Exception where it cannot; it has failed
   */
  default void start(RobletSpeech speech) throws Exception {}

  /**
   * Does what it does once.
   *
   * @param speech says messages
   * @throws Exception where it cannot; it has failed
   */
  void run(RobletSpeech speech) throws Exception;

  /**
   * Takes a message of the brain or of a roblet of which it is a friend; the newest of each name, where several came.
   *
   * @param from {@code brain}, or the name of the roblet
   * @param message what it says
   * @param speech says messages
   * @throws Exception where it cannot; it has failed
   */
  default void receive(String from, BodyElement message, RobletSpeech speech) throws Exception {}

  /** Ends, also where it has failed: releases what it holds. */
  default void stop() {}
}
