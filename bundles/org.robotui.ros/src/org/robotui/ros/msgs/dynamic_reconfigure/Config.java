package org.robotui.ros.msgs.dynamic_reconfigure;

import java.util.List;

import org.robotui.message.MessageType;

/**
 * Values of parameters ({@code dynamic_reconfigure/Config}).
 *
 * @param bools truth values
 * @param ints whole numbers
 * @param strs texts
 * @param doubles numbers
 * @param groups states of groups
 */
@MessageType("dynamic_reconfigure/Config")
public record Config(List<BoolParameter> bools, List<IntParameter> ints, List<StrParameter> strs,
    List<DoubleParameter> doubles, List<GroupState> groups) {

  /** Keeps immutable copies of lists. */
  public Config {
    bools = List.copyOf(bools);
    ints = List.copyOf(ints);
    strs = List.copyOf(strs);
    doubles = List.copyOf(doubles);
    groups = List.copyOf(groups);
  }
}
