package org.robotui.ui.control;

import java.util.List;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.FieldValue;

/** A part of a form. Display thread. */
sealed interface FormNode permits FormLeaf, FormGroup, FormArray {
  String path();

  /** The last step of the path. */
  String name();

  FieldShape shape();

  /** What was typed, of the kinds of Java values that messages are built from; call only where nothing is wrong. */
  Object value();

  void problems(List<FormProblem> into);

  /** As at the beginning. */
  void reset();

  /** Takes over what a record holds; a value of another kind is left out. */
  void fill(FieldValue value);
}
