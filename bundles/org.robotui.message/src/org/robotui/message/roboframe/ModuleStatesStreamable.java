package org.robotui.message.roboframe;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * How the modules of an application are doing ({@code roboframe/ModuleStates}).
 *
 * @param stamp when it was said, nanoseconds by the clock of the application
 * @param modules all of them
 */
@MessageType("roboframe/ModuleStates")
public record ModuleStatesStreamable(long stamp, List<ModuleStateStreamable> modules) {
  /** Takes a copy. */
  public ModuleStatesStreamable {
    modules = List.copyOf(modules);
  }
}
