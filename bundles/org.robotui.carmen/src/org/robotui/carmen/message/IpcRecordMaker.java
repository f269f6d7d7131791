package org.robotui.carmen.message;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.robotui.carmen.format.IpcFormat;
import org.robotui.carmen.format.IpcPrimitive;

/** Makes a message field by field, by names. Members that say how long an array is are set with it. For one thread. */
public final class IpcRecordMaker {

  private final IpcForm form;
  private final IpcFormat.Struct struct;
  private final List<IpcValue> values = new ArrayList<>();

  IpcRecordMaker(IpcForm form) {
    this.form = form;
    this.struct = form.format() instanceof IpcFormat.Struct s ? s
        : new IpcFormat.Struct(form.isEmpty() ? List.of() : List.of(form.format()));
    for (int i = 0; i < form.fields().size(); i++) {
      values.add(zero(struct.members().get(i), form.fields().get(i)));
    }
  }

  /**
   * Of what it is a message.
   *
   * @return its form
   */
  public IpcForm form() {
    return form;
  }

  /**
   * Sets a number.
   *
   * @param field its name
   * @param value is cut to a whole number where the field is one
   * @return this
   * @throws IllegalArgumentException where there is no such field, or it is no number
   */
  public IpcRecordMaker number(String field, double value) {
    int at = at(field);
    if (!(struct.members().get(at) instanceof IpcFormat.Single single) || single.type() == IpcPrimitive.STRING) {
      throw new IllegalArgumentException(form.name() + ": " + field + " is no number");
    }
    values.set(at, switch (single.type()) {
      case FLOAT -> new IpcValue.Small((float) value);
      case DOUBLE -> new IpcValue.Real(value);
      default -> new IpcValue.Whole((int) value);
    });
    return this;
  }

  /**
   * Sets a text.
   *
   * @param field its name
   * @param value of characters of 8 bits
   * @return this
   */
  public IpcRecordMaker text(String field, String value) {
    values.set(at(field), new IpcValue.Text(value));
    return this;
  }

  /**
   * Sets a format.
   *
   * @param field its name
   * @param value what it says
   * @return this
   */
  public IpcRecordMaker format(String field, IpcFormat value) {
    values.set(at(field), new IpcValue.Form(value));
    return this;
  }

  /**
   * Sets a structure of numbers, such as a pose.
   *
   * @param field its name
   * @param numbers as many as it has members
   * @return this
   */
  public IpcRecordMaker struct(String field, double... numbers) {
    int at = at(field);
    values.set(at, structure(struct.members().get(at), form.fields().get(at), numbers));
    return this;
  }

  /**
   * Sets a structure of any members.
   *
   * @param field its name
   * @param value its members
   * @return this
   */
  public IpcRecordMaker members(String field, IpcValue.Members value) {
    values.set(at(field), value);
    return this;
  }

  /**
   * Sets an array of structures of numbers.
   *
   * @param field its name
   * @param elements each with as many numbers as a structure has members
   * @return this
   */
  public IpcRecordMaker structs(String field, List<double[]> elements) {
    int at = at(field);
    IpcFormat element = struct.members().get(at) instanceof IpcFormat.VariableArray a ? a.element()
        : new IpcFormat.Nothing();
    return array(at, elements.size(), new IpcValue.Items(
        elements.stream().map(each -> structure(element, form.fields().get(at), each)).toList()));
  }

  /**
   * Sets an array of bytes or characters.
   *
   * @param field its name
   * @param bytes its elements
   * @return this
   */
  public IpcRecordMaker octets(String field, byte[] bytes) {
    return array(at(field), bytes.length, new IpcValue.Octets(bytes.clone()));
  }

  /**
   * Sets an array of numbers of 32 bits.
   *
   * @param field its name
   * @param numbers its elements
   * @return this
   */
  public IpcRecordMaker floats(String field, float[] numbers) {
    return array(at(field), numbers.length, new IpcValue.Smalls(numbers.clone()));
  }

  /**
   * Sets an array of numbers of 64 bits.
   *
   * @param field its name
   * @param numbers its elements
   * @return this
   */
  public IpcRecordMaker doubles(String field, double[] numbers) {
    return array(at(field), numbers.length, new IpcValue.Reals(numbers.clone()));
  }

  /**
   * Sets an array of whole numbers.
   *
   * @param field its name
   * @param numbers its elements
   * @return this
   */
  public IpcRecordMaker wholes(String field, int[] numbers) {
    return array(at(field), numbers.length, new IpcValue.Wholes(numbers.clone()));
  }

  /**
   * Sets an array of texts.
   *
   * @param field its name
   * @param texts its elements
   * @return this
   */
  public IpcRecordMaker texts(String field, List<String> texts) {
    return array(at(field), texts.size(),
        new IpcValue.Items(texts.stream().<IpcValue>map(IpcValue.Text::new).toList()));
  }

  /**
   * The message.
   *
   * @return with the values so far
   */
  public IpcRecord build() {
    return new IpcRecord(form.fields(), values);
  }

  private IpcRecordMaker array(int at, int size, IpcValue value) {
    if (struct.members().get(at) instanceof IpcFormat.VariableArray array) {
      values.set(array.members().getFirst() - 1, new IpcValue.Whole(size));
    }
    values.set(at, value);
    return this;
  }

  private int at(String field) {
    for (int i = 0; i < form.fields().size(); i++) {
      if (form.fields().get(i).name().equals(field)) {
        return i;
      }
    }
    throw new IllegalArgumentException(form.name() + " has no field " + field);
  }

  private static IpcValue structure(IpcFormat format, FieldName name, double... numbers) {
    if (!(format instanceof IpcFormat.Struct struct) || struct.members().size() != numbers.length) {
      throw new IllegalArgumentException(name.name() + " is no structure of " + numbers.length + " numbers");
    }
    List<IpcValue> members = new ArrayList<>();
    for (int i = 0; i < numbers.length; i++) {
      IpcPrimitive type = struct.members().get(i) instanceof IpcFormat.Single s ? s.type() : IpcPrimitive.STRING;
      members.add(switch (type) {
        case FLOAT -> new IpcValue.Small((float) numbers[i]);
        case DOUBLE -> new IpcValue.Real(numbers[i]);
        case STRING, FORMAT -> throw new IllegalArgumentException(name.name() + " has members that are no numbers");
        default -> new IpcValue.Whole((int) numbers[i]);
      });
    }
    return new IpcValue.Members(new IpcRecord(name.members(), members));
  }

  private static IpcValue zero(IpcFormat format, FieldName name) {
    return switch (format) {
      case IpcFormat.Single s -> zero(s.type());
      case IpcFormat.Struct s -> {
        List<IpcValue> members = new ArrayList<>();
        for (int i = 0; i < s.members().size(); i++) {
          members.add(zero(s.members().get(i), name.members().get(i)));
        }
        yield new IpcValue.Members(new IpcRecord(name.members(), members));
      }
      case IpcFormat.VariableArray a -> zeros(a.element(), 0, name);
      case IpcFormat.FixedArray a -> zeros(a.element(), a.count(), name);
      case IpcFormat.Opaque o -> new IpcValue.Octets(new byte[o.bytes()]);
      default -> new IpcValue.Absent();
    };
  }

  private static IpcValue zero(IpcPrimitive type) {
    return switch (type) {
      case FLOAT -> new IpcValue.Small(0);
      case DOUBLE -> new IpcValue.Real(0);
      case STRING -> new IpcValue.Text("");
      case FORMAT -> new IpcValue.Form(new IpcFormat.Nothing());
      default -> new IpcValue.Whole(0);
    };
  }

  private static IpcValue zeros(IpcFormat element, int count, FieldName name) {
    IpcPrimitive type = element instanceof IpcFormat.Single s ? s.type() : IpcPrimitive.STRING;
    return switch (type) {
      case FORMAT -> throw new IllegalArgumentException(name.name() + " is an array of formats");
      case FLOAT -> new IpcValue.Smalls(new float[count]);
      case DOUBLE -> new IpcValue.Reals(new double[count]);
      case INT, BOOLEAN -> new IpcValue.Wholes(new int[count]);
      case STRING -> new IpcValue.Items(Collections.nCopies(count, zero(element, name)));
      default -> new IpcValue.Octets(new byte[count]);
    };
  }
}
