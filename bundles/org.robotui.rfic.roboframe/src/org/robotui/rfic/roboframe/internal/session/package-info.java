/** One connection to an application, and what is offered through it. */
package org.robotui.rfic.roboframe.internal.session;
