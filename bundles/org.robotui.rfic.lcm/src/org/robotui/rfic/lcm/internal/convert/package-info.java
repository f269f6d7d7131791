/** What messages become: data types out of fields, and fields out of commands. */
package org.robotui.rfic.lcm.internal.convert;
