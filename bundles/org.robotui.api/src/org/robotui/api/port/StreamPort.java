package org.robotui.api.port;

import org.robotui.data.Data;
import org.robotui.data.DataType;

/**
 * A port for data out of a robot.
 *
 * @param <T> the type of the data
 * @param name unique within the component
 * @param type what is produced, or at least accepted
 * @param arity how many connections a view takes
 * @param help a sentence for users
 * @param intake what a view takes of the streams that fit
 */
public record StreamPort<T extends Data>(String name, Class<T> type, Arity arity, String help, Intake intake)
    implements Port {
  /**
   * A port that takes all that matching connects.
   *
   * @param name unique within the component
   * @param type what is produced, or at least accepted
   * @param arity how many connections a view takes
   * @param help a sentence for users
   */
  public StreamPort(String name, Class<T> type, Arity arity, String help) {
    this(name, type, arity, help, Intake.MATCHED);
  }

  @Override
  public PortKind kind() {
    return PortKind.STREAM;
  }

  @Override
  public String typeName() {
    return dataType().name();
  }

  /**
   * How its values are delivered.
   *
   * @return the description of the type
   */
  public DataType dataType() {
    return DataType.of(type);
  }
}
