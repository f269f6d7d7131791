package org.robotui.carmen.internal;

import org.robotui.carmen.message.IpcForm;

/** What modules say to a central and hear from it for itself. These have no length before their fields. */
public final class SystemMessages {

  /** In which form all messages of programs are sent. */
  public static final String WRAPPED = "{int, <byte:1>}";

  /** Asks for what is known of a message by its name. */
  public static final IpcForm ASK_INFO = IpcForm.of("x_ipc_msgInfo", "{string,string}", "name handler");
  /** The answer. */
  public static final IpcForm INFO =
      IpcForm.of("x_ipc_msgInfo reply", "*{int,string,int,format,format}", "info{id name kind wire content}");
  /** A module introduces itself. */
  public static final IpcForm CONNECT =
      IpcForm.of("x_ipc_newModuleConnectMsg", "{string,string}", "module host");
  /** The answer. */
  public static final IpcForm CONNECTED =
      IpcForm.of("x_ipc_newModuleConnectMsg reply", "{{int,int},boolean}", "version{major minor} direct");
  /** A message exists. */
  public static final IpcForm REGISTER_MESSAGE =
      IpcForm.of("x_ipc_registerMessageMsg", "{string,int,string,string}", "name kind wire content");
  /** A message is handled by a module. */
  public static final IpcForm REGISTER_HANDLER =
      IpcForm.of("x_ipc_registerHandlerMsg", "{int,string,string}", "id message handler");
  /** How many messages may wait for a module. */
  public static final IpcForm LIMIT =
      IpcForm.of("x_ipc_limitPendingMsg", "{string,string,int}", "message module limit");
  /** How much a module takes at once. */
  public static final IpcForm RESOURCE =
      IpcForm.of("x_ipc_registerResourceMsg", "{int,string}", "capacity module");
  /** Where a module listens for others. */
  public static final IpcForm DIRECT =
      IpcForm.of("x_ipc_directResMsg", "{int,string}", "port module");
  /** Who handles a message directly. */
  public static final IpcForm ASK_DIRECT = IpcForm.of("x_ipc_directMsgQuery", "string", "message");
  /** The answer. */
  public static final IpcForm DIRECT_HANDLERS = IpcForm.of("x_ipc_directMsgQuery reply",
      "{int,<{int,int,int,int,string,string}:1>}", "count handlers{handler field2 field3 port host module}");
  /** Which messages are handled by somebody. */
  public static final IpcForm HANDLED = IpcForm.of("V_get_X_IPC_BROADCAST_MSG_VAR", "", "");
  /** The answer. */
  public static final IpcForm HANDLED_NAMES =
      IpcForm.of("V_get_X_IPC_BROADCAST_MSG_VAR reply", "{int,int,<string:2>}", "used size names");
  /** A module goes. */
  public static final IpcForm CLOSE = IpcForm.of("x_ipc_CloseMsg", "", "");

  private SystemMessages() {}
}
