package org.robotui.ros.msgs.dynamic_reconfigure;

import java.util.List;

import org.robotui.message.MessageType;

/**
 * A group of parameters ({@code dynamic_reconfigure/Group}).
 *
 * @param name the group
 * @param type how it is shown; empty for the usual way
 * @param parameters what is in it
 * @param parent number of the group that holds it; its own for the outermost
 * @param id number of the group
 */
@MessageType("dynamic_reconfigure/Group")
public record Group(String name, String type, List<ParamDescription> parameters, int parent, int id) {

  /** Keeps immutable copies of lists. */
  public Group {
    parameters = List.copyOf(parameters);
  }
}
