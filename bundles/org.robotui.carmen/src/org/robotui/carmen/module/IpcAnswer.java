package org.robotui.carmen.module;

import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForm;

/**
 * What a module answers.
 *
 * @param form of the answer
 * @param record its fields
 */
public record IpcAnswer(IpcForm form, IpcRecord record) {}
